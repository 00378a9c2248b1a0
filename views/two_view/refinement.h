// Minimises the sum of squared Sampson distances, starting from a first estimate, by Levenberg and
// Marquardt's method (Eigen's MINPACK).
#pragma once

#include "views/two_view/match.h"
#include "views/two_view/triangulation.h"

namespace glassbox::views {

// The pose of a rig with the given intrinsics, from matches in pixels. There are 5 unknowns: a
// rotation and the direction of T. |T| does not change.
RelativePose refined_pose(const StereoRig& first, const Matches& pixels);

// F with 7 unknowns: it is U diag(1, s, 0) V^T, where U and V are rotated (3 unknowns each) and s
// is changed. The result has Frobenius norm 1.
Matrix3d refined_fundamental(const Matrix3d& first, const Matches& pixels);

}  // namespace glassbox::views
