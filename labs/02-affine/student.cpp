// Lab 2: your part. student.h says what each function must do, handout.md why.
#include "student.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/matrix.hpp>

namespace lab_02 {

// ---- task 2.1: about a point of the plane ----

Matrix3 turn_about(const Point2& centre, double degrees) {
  // BEGIN SOLUTION
  const double angle = degrees * (std::numbers::pi / 180);
  const double c = std::cos(angle), s = std::sin(angle);
  const double x = centre.x - (c * centre.x - s * centre.y);
  const double y = centre.y - (s * centre.x + c * centre.y);
  return Matrix3{{{c, -s, x}, {s, c, y}, {0, 0, 1}}};
  // STUB: return Matrix3{{{NAN}}};  // T(centre) R T(-centre)
  // END SOLUTION
}

// ---- task 2.2: one step after the other ----

// BEGIN SOLUTION
static Transform<World, World> rotation(const Vector<World, double>& about, double degrees) {
  // Divided by its largest component first, so that no square overflows or becomes 0.
  const double largest = std::max({std::abs(about.x), std::abs(about.y), std::abs(about.z)});
  const Vector<World, double> axis{about.x / largest, about.y / largest, about.z / largest};
  const double length = std::sqrt(dot(axis, axis));
  const double a[3] = {axis.x / length, axis.y / length, axis.z / length};
  const double angle = degrees * (std::numbers::pi / 180);
  const double c = std::cos(angle), s = std::sin(angle);
  Transform<World, World> m;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    m.at(i, i) = a[i] * a[i] * (1 - c) + c;
    m.at(i, j) = a[i] * a[j] * (1 - c) - a[k] * s;
    m.at(j, i) = a[i] * a[j] * (1 - c) + a[k] * s;
  }
  return m;
}

static Transform<World, World> matrix_of(const Step& step) {
  Transform<World, World> m;
  const double v[3] = {step.v.x, step.v.y, step.v.z};
  switch (step.kind) {
    case Step::Kind::kTranslate:
      for (int i = 0; i < 3; ++i) m.at(i, 3) = v[i];
      break;
    case Step::Kind::kRotate:
      return rotation(step.v, step.amount);
    case Step::Kind::kScale:
      for (int i = 0; i < 3; ++i) m.at(i, i) = v[i];
      break;
    case Step::Kind::kShear:
      m.at(step.changed, step.by) = step.amount;
      break;
  }
  return m;
}
// STUB:
// END SOLUTION

Transform<World, Object> compose(const std::vector<Step>& steps) {
  // BEGIN SOLUTION
  Transform<World, Object> all;
  for (const Step& step : steps) all = matrix_of(step) * all;
  return all;
  // STUB: return Transform<World, Object>(glm::dmat4(NAN));  // the product, steps[0] rightmost
  // END SOLUTION
}

// ---- task 2.3: from three points to a map ----

std::optional<Matrix3> fit_affine(const std::array<Point2, 3>& source,
                                  const std::array<Point2, 3>& target) {
  // BEGIN SOLUTION
  const Point2 e{source[1].x - source[0].x, source[1].y - source[0].y};
  const Point2 f{source[2].x - source[0].x, source[2].y - source[0].y};
  const Point2 g{target[1].x - target[0].x, target[1].y - target[0].y};
  const Point2 h{target[2].x - target[0].x, target[2].y - target[0].y};
  const double det = e.x * f.y - f.x * e.y;
  if (det == 0) return std::nullopt;
  // The linear part of the map is [g h] [e f]^-1, with e, f and g, h as the columns.
  const double a = (g.x * f.y - h.x * e.y) / det, b = (h.x * e.x - g.x * f.x) / det;
  const double c = (g.y * f.y - h.y * e.y) / det, d = (h.y * e.x - g.y * f.x) / det;
  const Point2 p = source[0];
  return Matrix3{{{a, b, target[0].x - (a * p.x + b * p.y)},
                  {c, d, target[0].y - (c * p.x + d * p.y)},
                  {0, 0, 1}}};
  // STUB: return Matrix3{};  // std::nullopt where the points lie on a line
  // END SOLUTION
}

// ---- task 2.4: which rotation is this? ----

AxisAngle axis_angle_of(const Transform<World, World>& rotation) {
  // BEGIN SOLUTION
  const auto& r = rotation;
  const Vector<World, double> across{(r.at(2, 1) - r.at(1, 2)) / 2, (r.at(0, 2) - r.at(2, 0)) / 2,
                                     (r.at(1, 0) - r.at(0, 1)) / 2};
  const double sine = std::sqrt(dot(across, across));
  const double cosine = (r.at(0, 0) + r.at(1, 1) + r.at(2, 2) - 1) / 2;
  AxisAngle found;
  found.radians = std::atan2(sine, cosine);
  if (cosine >= 0) {
    if (sine > 0) found.axis = across * (1 / sine);
    return found;
  }
  // With the axis a, (R + R^T)/2 - cos I = (1 - cos) a a^T. The longest column of this matrix,
  // which gives the most exact axis, is that with the largest diagonal entry.
  int column = 0;
  for (int i = 1; i < 3; ++i) {
    if (r.at(i, i) > r.at(column, column)) column = i;
  }
  double a[3];
  for (int i = 0; i < 3; ++i) a[i] = (r.at(i, column) + r.at(column, i)) / 2;
  a[column] -= cosine;
  const Vector<World, double> along{a[0], a[1], a[2]};
  double side = dot(along, across);
  for (int i = 0; i < 3 && side == 0; ++i) side = a[i];  // half a turn
  found.axis = along * ((side < 0 ? -1 : 1) / std::sqrt(dot(along, along)));
  return found;
  // STUB: return {{NAN, NAN, NAN}, NAN};  // the axis, and the angle in radians
  // END SOLUTION
}

// ---- task 2.5: a rotation again ----

Transform<World, World> repaired(const Transform<World, World>& almost_rotation) {
  // BEGIN SOLUTION
  const auto column = [&](int j) {
    return Vector<World, double>{almost_rotation.at(0, j), almost_rotation.at(1, j),
                                 almost_rotation.at(2, j)};
  };
  const auto unit = [](const Vector<World, double>& v) { return v * (1 / std::sqrt(dot(v, v))); };
  const Vector<World, double> x = unit(column(0));
  const Vector<World, double> y = unit(column(1) - x * dot(x, column(1)));
  const Vector<World, double> z = unit(cross(x, y));
  const double rows[3][3] = {{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}};
  Transform<World, World> result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) result.at(i, j) = rows[i][j];
  }
  return result;
  // STUB: return Transform<World, World>(glm::dmat4(NAN));  // perpendicular columns of length 1
  // END SOLUTION
}

}  // namespace lab_02
