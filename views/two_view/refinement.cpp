#include "views/two_view/refinement.h"

#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "views/two_view/least_squares.h"
#include "views/two_view/linear_fit.h"
#include "views/two_view/residual.h"
#include "views/two_view/rotation.h"

namespace glassbox::views {

namespace {

// Finds the parameters for which the resulting matrix has the least sum of squared Sampson
// distances. The search begins with all parameters at 0.
template <class MatrixOf>
Eigen::VectorXd nearest_to_matches(const MatrixOf& matrix_of, const Matches& pixels, int unknowns) {
  return least_squares(unknowns, int(pixels.size()),
                       [&](const Eigen::VectorXd& at, Eigen::VectorXd& distances) {
                         const Matrix3d matrix = matrix_of(at);
                         for (Eigen::Index i = 0; i < distances.size(); ++i)
                           distances[i] = sampson_distance(matrix, pixels[std::size_t(i)]);
                       });
}

}  // namespace

RelativePose refined_pose(const StereoRig& first, const Matches& pixels) {
  const Vector3d direction = first.pose.translation.normalized();
  const Vector3d across = direction.unitOrthogonal(), up = direction.cross(across);
  const auto pose_at = [&](const Eigen::VectorXd& at) {
    const Vector3d moved = direction + at[3] * across + at[4] * up;
    return RelativePose{turned_by(at.head<3>()) * first.pose.rotation,
                        first.pose.translation.norm() * moved.normalized()};
  };
  const auto matrix_at = [&](const Eigen::VectorXd& at) {
    return fundamental_of({first.left_intrinsic, first.right_intrinsic, pose_at(at)});
  };
  constexpr int kUnknowns = 5;
  return pose_at(nearest_to_matches(matrix_at, pixels, kUnknowns));
}

Matrix3d refined_fundamental(const Matrix3d& first, const Matches& pixels) {
  // Pixel coordinates are much larger than 1, so the seven unknowns change the matrix for
  // normalised points: two rotations, and the ratio of its singular values.
  const auto from = normalised(pixels);
  if (!from) return first.normalized();
  const Matrix3d there = from->right.inverse().transpose() * first * from->left.inverse();
  const Eigen::JacobiSVD<Matrix3d> svd(there, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double ratio = svd.singularValues()[1] / svd.singularValues()[0];
  const auto matrix_at = [&](const Eigen::VectorXd& at) {
    const Vector3d values(1, ratio + at[6], 0);
    const Matrix3d matrix = turned_by(at.head<3>()) * svd.matrixU() * values.asDiagonal() *
                            svd.matrixV().transpose() * turned_by(at.segment<3>(3));
    return Matrix3d(from->right.transpose() * matrix * from->left);
  };
  constexpr int kUnknowns = 7;
  return matrix_at(nearest_to_matches(matrix_at, pixels, kUnknowns)).normalized();
}

}  // namespace glassbox::views
