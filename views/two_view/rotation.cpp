#include "views/two_view/rotation.h"

#include <algorithm>
#include <cmath>

#include <glassbox/base/trig.h>

namespace glassbox::views {

Matrix3d turned_by(const Vector3d& rotation_vector) {
  const double angle = rotation_vector.norm();
  if (angle == 0) return Matrix3d::Identity();
  const Vector3d axis = rotation_vector / angle;
  const auto [sine, cosine] = sin_cos(angle);
  Matrix3d cross;
  cross << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
  return cosine * Matrix3d::Identity() + sine * cross + (1 - cosine) * axis * axis.transpose();
}

// For two rotations A and B whose relative rotation has the angle a, the Frobenius norm |A - B| is
// 2 sqrt 2 sin(a / 2). It is accurate for small angles, while the cosine from the trace of A^T B is
// not.
double rotation_error(const Matrix3d& estimated, const Matrix3d& truth) {
  const double half = (estimated - truth).norm() / (2 * std::sqrt(2.0));
  const double sine = std::min(1.0, half);
  return 2 * arctan2(sine, std::sqrt((1 - sine) * (1 + sine)));
}

}  // namespace glassbox::views
