// The rival of the epipolar constraint: p_r = H p_l for all points, which is so for a plane and for a camera that only turns.
#pragma once

#include <Eigen/Core>

#include <glassbox/base/error.h>

#include "views/two_view/match.h"

namespace glassbox::views {

// The least squares solution of four matches or more, with normalised points; det H > 0 and Frobenius norm 1.
Result<Eigen::Matrix3d> fit_homography(const Matches& matches);

}  // namespace glassbox::views
