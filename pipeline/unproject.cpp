#include <glassbox/pipeline/unproject.h>

#include <cmath>

#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/number_text.h>

namespace glassbox {

Result<Point<World, double>> unproject(const View& view, const Point<Screen, double>& screen) {
  const Transform<Clip, Eye>& m = view.clip_from_eye;
  const double left = view.viewport.left, right = view.viewport.right;
  const double top = view.viewport.top, bottom = view.viewport.bottom;
  // Solves X = x (right - left)/2 + (right + left)/2, the formula of to_screen, for x. It is the
  // same for y, which points down on the screen.
  const double ndc_x = (2 * screen.x - (right + left)) / (right - left);
  const double ndc_y = (2 * screen.y - (bottom + top)) / (top - bottom);

  Point<Eye, double> eye;
  if (view.perspective) {
    // depth = (A z + B)/(-z) with the entries A = (2, 2) and B = (2, 3), so z = -B/(A + depth).
    // x_ndc = (sx x + ox z)/(-z) with the entries sx = (0, 0) and ox = (0, 2).
    const double z = -m.at(2, 3) / (m.at(2, 2) + screen.z);
    if (!(z < 0) || std::isinf(z)) {
      return fail("depth", "no point in front of the eye has the depth " + number_text(screen.z),
                  "give a depth between the near and the far plane's");
    }
    eye.z = z;
    eye.x = -z * (ndc_x + m.at(0, 2)) / m.at(0, 0);
    eye.y = -z * (ndc_y + m.at(1, 2)) / m.at(1, 1);
  } else {
    eye.z = (screen.z - m.at(2, 3)) / m.at(2, 2);
    eye.x = (ndc_x - m.at(0, 3)) / m.at(0, 0);
    eye.y = (ndc_y - m.at(1, 3)) / m.at(1, 1);
  }
  return inverse_rigid(view.eye_from_world) * eye;
}

double distance_per_depth(const View& view, double distance) {
  if (!view.perspective) return std::abs(1 / view.clip_from_eye.at(2, 2));
  return distance * distance / std::abs(view.clip_from_eye.at(2, 3));
}

}  // namespace glassbox
