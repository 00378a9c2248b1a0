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

// The error e = p_r - H p_l has the covariance C = I + A A^T if the four coordinates have
// independent errors of variance 1, where A is the derivative of H p_l with respect to p_l. With
// Cholesky's factor L of C, L^-1 e has the covariance I.
Eigen::Vector2d transfer_residual(const Eigen::Matrix3d& homography, const Match& match) {
  const Eigen::Vector3d moved = homography * match.left.homogeneous();
  const Eigen::Vector2d at = moved.hnormalized(), error = match.right - at;
  const Eigen::Matrix2d slope =
      (homography.topLeftCorner<2, 2>() - at * homography.row(2).head<2>()) / moved.z();
  const Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity() + slope * slope.transpose();
  const double first = std::sqrt(covariance(0, 0)), below = covariance(1, 0) / first;
  const double second = std::sqrt(covariance(1, 1) - below * below);
  const double x = error.x() / first;
  return {x, (error.y() - below * x) / second};
}

}  // namespace glassbox::views
