#include "views/two_view/refinement.h"

#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "views/two_view/least_squares.h"
#include "views/two_view/linear_fit.h"
#include "views/two_view/plane_pose.h"
#include "views/two_view/residual.h"
#include "views/two_view/rotation.h"

namespace glassbox::views {

namespace {

// Finds the parameters for which the resulting matrix has the least sum of squared Sampson
// distances. The search begins with all parameters at 0.
template <class MatrixOf>
Eigen::VectorXd nearest_to_matches(const MatrixOf& matrix_of, const Matches& pixels, double limit,
                                   int unknowns) {
  return least_squares(
      unknowns, int(pixels.size()), [&](const Eigen::VectorXd& at, Eigen::VectorXd& distances) {
        const Matrix3d matrix = matrix_of(at);
        for (Eigen::Index i = 0; i < distances.size(); ++i)
          distances[i] = limited(sampson_distance(matrix, pixels[std::size_t(i)]), limit);
      });
}

// The pose for five unknowns: a rotation vector, and the movement of T across its direction.
RelativePose moved_pose(const RelativePose& first, const Eigen::VectorXd& at) {
  const Vector3d direction = first.translation.normalized();
  const Vector3d across = direction.unitOrthogonal(), up = direction.cross(across);
  const Vector3d moved = direction + at[3] * across + at[4] * up;
  return {turned_by(at.head<3>()) * first.rotation, first.translation.norm() * moved.normalized()};
}

}  // namespace

double limited(double residual, double limit) {
  if (std::isnan(residual)) return limit;
  const double ratio = residual / limit;
  return residual / std::sqrt(1 + ratio * ratio);
}

RelativePose refined_pose(const StereoRig& first, const Matches& pixels, double limit) {
  const auto matrix_at = [&](const Eigen::VectorXd& at) {
    return fundamental_of(
        {first.left_intrinsic, first.right_intrinsic, moved_pose(first.pose, at)});
  };
  constexpr int kUnknowns = 5;
  return moved_pose(first.pose, nearest_to_matches(matrix_at, pixels, limit, kUnknowns));
}

RefinedPlane refined_plane(const StereoRig& rig, const Vector3d& plane, const Matches& on_plane,
                           const Matches& others, double limit) {
  constexpr int kUnknowns = 8;
  struct State {
    RelativePose pose;
    Vector3d plane;
  } start{rig.pose, plane};
  const auto moved = [&](const Eigen::VectorXd& at) {
    return State{moved_pose(start.pose, at), start.plane + start.plane.norm() * at.tail<3>()};
  };
  const auto residuals = [&](const Eigen::VectorXd& at, Eigen::VectorXd& off) {
    const State state = moved(at);
    const StereoRig there{rig.left_intrinsic, rig.right_intrinsic, state.pose};
    const Matrix3d homography = homography_of(there, state.plane);
    const Matrix3d fundamental = fundamental_of(there);
    Eigen::Index row = 0;
    for (const Match& match : on_plane) {
      off.segment<2>(row) = transfer_residual(homography, match);
      row += 2;
    }
    for (const Match& match : others) {
      off[row++] = limited(sampson_distance(fundamental, match), limit);
    }
  };
  const int count = int(2 * on_plane.size() + others.size());
  start = moved(least_squares(kUnknowns, count, residuals));
  const Eigen::MatrixXd covariance = covariance_at_zero(kUnknowns, count, residuals);
  return {start.pose, start.plane,
          start.plane.squaredNorm() * Matrix3d(covariance.bottomRightCorner<3, 3>())};
}

Matrix3d refined_fundamental(const Matrix3d& first, const Matches& pixels, double limit) {
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
  return matrix_at(nearest_to_matches(matrix_at, pixels, limit, kUnknowns)).normalized();
}

}  // namespace glassbox::views
