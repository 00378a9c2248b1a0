#include "views/two_view/rotation.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace glassbox::views {

Matrix3d turned_by(const Vector3d& rotation_vector) {
  const double angle = rotation_vector.norm();
  if (angle == 0) return Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, rotation_vector / angle).matrix();
}

// |A - B| of two rotations is 2 sqrt 2 sin(angle / 2), which small angles keep their digits in, as the trace's cosine does not.
double rotation_error(const Matrix3d& estimated, const Matrix3d& truth) {
  const double half = (estimated - truth).norm() / (2 * std::sqrt(2.0));
  return 2 * std::asin(std::min(1.0, half));
}

}  // namespace glassbox::views
