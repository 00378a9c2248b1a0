#include "views/two_view/pose.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <glassbox/base/trig.h>

#include "views/two_view/triangulation.h"

namespace glassbox::views {

namespace {

Matrix3d of_determinant_one(const Matrix3d& orthogonal) {
  return orthogonal.determinant() < 0 ? Matrix3d(-orthogonal) : orthogonal;
}

}  // namespace

// With E = U diag(1, 1, 0) V^T and a quarter turn W about the third axis, the possible rotations
// are U W V^T and U W^T V^T; E T = 0 makes T the last column of V.
std::array<RelativePose, 4> poses_of(const Matrix3d& essential) {
  const Eigen::JacobiSVD<Matrix3d> svd(essential, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Matrix3d quarter_turn;
  quarter_turn << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  const Matrix3d u = svd.matrixU(), v = svd.matrixV();
  const Matrix3d one = of_determinant_one(u * quarter_turn * v.transpose());
  const Matrix3d other = of_determinant_one(u * quarter_turn.transpose() * v.transpose());
  const Vector3d t = v.col(2);
  return {{{one, t}, {one, -t}, {other, t}, {other, -t}}};
}

int in_front_of_both(const RelativePose& pose, const Matches& calibrated) {
  return int(std::ranges::count_if(calibrated, [&](const Match& match) {
    const Rays rays{match.left.homogeneous(), match.right.homogeneous()};
    return midpoint(rays, pose).in_front_of_both;
  }));
}

std::optional<ChosenPose> pose_in_front(const Matrix3d& essential, const Matches& calibrated) {
  ChosenPose best;
  for (const RelativePose& pose : poses_of(essential)) {
    const int count = in_front_of_both(pose, calibrated);
    if (count > best.in_front) {
      best = {pose, count, best.in_front};
    } else {
      best.runner_up = std::max(best.runner_up, count);
    }
  }
  if (best.in_front == best.runner_up) return {};
  return best;
}

double direction_error(const Vector3d& estimated, const Vector3d& truth) {
  return arctan2(estimated.cross(truth).norm(), estimated.dot(truth));
}

}  // namespace glassbox::views
