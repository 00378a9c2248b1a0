// How far matches are from fulfilling the constraint, in the unit of their coordinates.
#pragma once

#include <Eigen/Core>

#include "views/two_view/match.h"

namespace glassbox::views {

// To first order, how far both points together have to be moved until p_r^T M p_l = 0 holds (Sampson's distance; Hartley and
// Zisserman, Multiple View Geometry, 11.4.3). Signed.
double sampson_distance(const Eigen::Matrix3d& matrix, const Match& match);

// From each point to the epipolar line of the other, the mean of both.
double epipolar_distance(const Eigen::Matrix3d& matrix, const Match& match);

// |H p_l - p_r| and |H^-1 p_r - p_l|: the root of the sum of their squares over 2. `inverse` is H^-1.
double transfer_distance(const Eigen::Matrix3d& homography, const Eigen::Matrix3d& inverse,
                         const Match& match);

}  // namespace glassbox::views
