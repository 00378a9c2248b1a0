// Homographies, the alternative to the epipolar constraint: p_r = H p_l up to scale for all points.
// This holds for points on a plane, and for a camera that only turns.
#pragma once

#include <Eigen/Core>

#include <glassbox/base/error.h>

#include "views/two_view/match.h"

namespace glassbox::views {

// The least squares solution for four or more matches, computed with normalised points; the result
// has det H > 0 and Frobenius norm 1.
Result<Eigen::Matrix3d> fit_homography(const Matches& matches);

}  // namespace glassbox::views
