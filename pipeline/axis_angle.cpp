#include <glassbox/pipeline/axis_angle.h>

#include <cmath>

#include <glassbox/pipeline/affine.h>

namespace glassbox {

namespace {

// The rotation of the unit vector v to -z, by Rodrigues' formula: cos I + [k]x + k k^T (1 -
// cos)/sin^2 with k = v x (-z) = (-vy, vx, 0), where [k]x is the matrix of the cross product with
// k. |k| is the sine of the angle and -vz its cosine, so the angle itself is never computed. k has
// no rounding error.
Transform<World, World> gaze_to_minus_z(const Vector<World, double>& v) {
  const double c = -v.z, sine_squared = v.x * v.x + v.y * v.y;
  if (sine_squared == 0)
    // v is +z or -z: rotate about y, by 180 degrees or by 0.
    return scale<World>(c < 0 ? -1 : 1, 1, c < 0 ? -1 : 1);
  const double factor = rodrigues_factor(c, sine_squared);
  const double kx = -v.y, ky = v.x;
  Transform<World, World> r;
  r.at(0, 0) = c + kx * kx * factor;
  r.at(0, 1) = kx * ky * factor;
  r.at(0, 2) = ky;
  r.at(1, 0) = kx * ky * factor;
  r.at(1, 1) = c + ky * ky * factor;
  r.at(1, 2) = -kx;
  r.at(2, 0) = -ky;
  r.at(2, 1) = kx;
  r.at(2, 2) = c;
  return r;
}

// The rotation about z that turns the direction (x, y) to +y.
Transform<Eye, World> roll_up(double x, double y) {
  const double length = std::sqrt(x * x + y * y);
  Transform<Eye, World> r;
  r.at(0, 0) = y / length;
  r.at(0, 1) = -(x / length);
  r.at(1, 0) = x / length;
  r.at(1, 1) = y / length;
  return r;
}

}  // namespace

AxisAngleFactors axis_angle_factors(const Point<World, double>& eye,
                                    const Vector<World, double>& gaze,
                                    const Vector<World, double>& up) {
  const Transform<World, World> turned = gaze_to_minus_z(gaze);
  const Vector<World, double> turned_up = turned * up;
  return {translate<World>(Vector<World, double>{-eye.x, -eye.y, -eye.z}), turned,
          roll_up(turned_up.x, turned_up.y)};
}

Transform<Eye, World> product(const AxisAngleFactors& factors) {
  Transform<Eye, World> m = factors.roll * factors.rotation * factors.translation;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) m.at(row, column) += 0.0;  // -0 becomes 0
  }
  return m;
}

}  // namespace glassbox
