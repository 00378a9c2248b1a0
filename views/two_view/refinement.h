// Minimises the sum of squared Sampson distances, starting from a first estimate, by Levenberg and
// Marquardt's method (Eigen's MINPACK).
#pragma once

#include <limits>

#include "views/two_view/match.h"
#include "views/two_view/triangulation.h"

namespace glassbox::views {

// A residual r with limited influence: r / sqrt(1 + (r/limit)^2) is nearly r far below the limit,
// and never above it (Geman and McClure, Bulletin of the ISI 52, 1987). The sum of its squares
// tells outliers from inliers without a sharp bound between them, so that it can be minimised.
inline constexpr double kNoLimit = std::numeric_limits<double>::infinity();
double limited(double residual, double limit);

// The pose of a rig with the given intrinsics, from matches in pixels. There are 5 unknowns: a
// rotation and the direction of T. |T| does not change. Each distance is limited as above.
RelativePose refined_pose(const StereoRig& first, const Matches& pixels, double limit = kNoLimit);

// The pose of a rig and the plane of the points that both cameras see, with 8 unknowns. A match of
// the plane has two residuals, those of the homography; the others have the distance from the
// epipolar constraint, which is limited. Planes are as in plane_pose.h.
struct RefinedPlane {
  RelativePose pose;  // |T| does not change
  Vector3d plane = Vector3d::Zero();
  Matrix3d covariance = Matrix3d::Zero();  // of `plane`, if a coordinate has an error of 1 px
};
RefinedPlane refined_plane(const StereoRig& rig, const Vector3d& plane, const Matches& on_plane,
                           const Matches& others, double limit);

// F with 7 unknowns: it is U diag(1, s, 0) V^T, where U and V are rotated (3 unknowns each) and s
// is changed. The result has Frobenius norm 1.
Matrix3d refined_fundamental(const Matrix3d& first, const Matches& pixels, double limit = kNoLimit);

}  // namespace glassbox::views
