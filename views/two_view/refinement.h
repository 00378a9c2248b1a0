// The least sum of squared Sampson distances near a first estimate, by Levenberg and Marquardt's method (Eigen's MINPACK).
#pragma once

#include "views/two_view/match.h"
#include "views/two_view/triangulation.h"

namespace glassbox::views {

// The pose of a rig with the given intrinsics, from matches in pixels: 5 unknowns, a rotation and the direction of T. |T| stays.
RelativePose refined_pose(const StereoRig& first, const Matches& pixels);

// F with 7 unknowns: U diag(1, s, 0) V^T, U and V turned, s moved. Of Frobenius norm 1.
Matrix3d refined_fundamental(const Matrix3d& first, const Matches& pixels);

}  // namespace glassbox::views
