#include "student.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace lab_04 {

Projection perspective(double fovy_radians, double aspect, double near, double far) {
  // BEGIN SOLUTION
  constexpr double kPi = 3.14159265358979323846;
  // The conditions are negated, so that NaN is rejected too: every comparison with NaN is false.
  if (!(fovy_radians > 0 && fovy_radians < kPi)) throw std::invalid_argument("field of view");
  if (!(aspect > 0 && std::isfinite(aspect))) throw std::invalid_argument("aspect ratio");
  if (!(near > 0 && near < far)) throw std::invalid_argument("near and far plane");
  const double cot = 1 / std::tan(fovy_radians / 2);
  // With near n and far f, alpha = f / (f - n), which tends to 1 as f grows to infinity.
  const double alpha = std::isinf(far) ? 1 : far / (far - near);
  Projection m;
  m.at(0, 0) = cot / aspect;
  m.at(1, 1) = cot;
  m.at(2, 2) = -alpha;
  m.at(2, 3) = -alpha * near;
  m.at(3, 2) = -1;
  m.at(3, 3) = 0;
  return m;
  // STUB: throw std::logic_error("4.1: perspective is not written yet");
  // END SOLUTION
}

Projection orthographic(double left, double right, double bottom, double top, double near,
                        double far) {
  // BEGIN SOLUTION
  Projection box;
  box.at(0, 0) = 2 / (right - left);
  box.at(0, 3) = -(right + left) / (right - left);
  box.at(1, 1) = 2 / (top - bottom);
  box.at(1, 3) = -(top + bottom) / (top - bottom);
  box.at(2, 2) = -1 / (far - near);
  box.at(2, 3) = -near / (far - near);
  return box;
  // STUB: throw std::logic_error("4.2: orthographic is not written yet");
  // END SOLUTION
}

Projection in_dialect(const Projection& m, Dialect dialect) {
  // BEGIN SOLUTION
  Projection changed = m;
  for (int i = 0; i < 4; ++i) {
    // A change of clip space happens after the projection and changes a row; a change of eye space
    // happens before it and changes a column.
    if (dialect == Dialect::kOpenGl) changed.at(2, i) = 2 * m.at(2, i) - m.at(3, i);
    if (dialect == Dialect::kReversed) changed.at(2, i) = m.at(3, i) - m.at(2, i);
    if (dialect == Dialect::kLeftHandedEye) changed.at(i, 2) = -m.at(i, 2);
  }
  return changed;
  // STUB: throw std::logic_error("4.3: in_dialect is not written yet");
  // END SOLUTION
}

std::optional<Point<Ndc, double>> divide(const Point<Clip, double>& p) {
  // BEGIN SOLUTION
  if (!(p.w > 0)) return std::nullopt;
  return Point<Ndc, double>(p.x / p.w, p.y / p.w, p.z / p.w);
  // STUB: throw std::logic_error("4.4: divide is not written yet");
  // END SOLUTION
}

Point<Screen, double> to_screen(const Point<Ndc, double>& p, const Rectangle& viewport) {
  // BEGIN SOLUTION
  const double x = viewport.left + (p.x + 1) / 2 * viewport.width;
  const double y = viewport.top + (1 - p.y) / 2 * viewport.height;
  return {x, y, p.z};
  // STUB: throw std::logic_error("4.5: to_screen is not written yet");
  // END SOLUTION
}

double distance_of(double depth, double near, double far) {
  // BEGIN SOLUTION
  // depth = f (z - n) / ((f - n) z) with near n and far f, solved for z. Dividing by f makes it
  // right for an infinite f, too. Both terms of the sum are positive, so nothing cancels even where
  // n/f is less than u: 1 - depth (1 - n/f) would then be 0 at depth 1, and the distance infinite.
  const double n_over_f = near / far;
  return near / ((1 - depth) + depth * n_over_f);
  // STUB: throw std::logic_error("4.6: distance_of is not written yet");
  // END SOLUTION
}

}  // namespace lab_04
