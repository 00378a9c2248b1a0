#include "views/two_view/residual.h"

#include <cmath>

#include <Eigen/Geometry>

#include <glassbox/base/elementary.h>

namespace glassbox::views {

namespace {

struct Lines {
  Eigen::Vector3d in_left, in_right;
  double value;  // p_r^T M p_l
};

Lines lines_of(const Eigen::Matrix3d& matrix, const Match& match) {
  const Eigen::Vector3d left = match.left.homogeneous(), right = match.right.homogeneous();
  const Eigen::Vector3d in_right = matrix * left;
  return {matrix.transpose() * right, in_right, right.dot(in_right)};
}

}  // namespace

double sampson_distance(const Eigen::Matrix3d& matrix, const Match& match) {
  const Lines lines = lines_of(matrix, match);
  return lines.value / hypotenuse(lines.in_left.head<2>().norm(), lines.in_right.head<2>().norm());
}

double epipolar_distance(const Eigen::Matrix3d& matrix, const Match& match) {
  const Lines lines = lines_of(matrix, match);
  const double value = std::abs(lines.value);
  return (value / lines.in_left.head<2>().norm() + value / lines.in_right.head<2>().norm()) / 2;
}

double transfer_distance(const Eigen::Matrix3d& homography, const Eigen::Matrix3d& inverse,
                         const Match& match) {
  const Eigen::Vector3d to_right = homography * match.left.homogeneous();
  const Eigen::Vector3d to_left = inverse * match.right.homogeneous();
  return hypotenuse((to_right.hnormalized() - match.right).norm(),
                    (to_left.hnormalized() - match.left).norm()) /
         std::sqrt(2.0);
}

}  // namespace glassbox::views
