// How far matches are from fulfilling the constraint, in the unit of their coordinates.
#pragma once

#include <Eigen/Core>

#include "views/two_view/match.h"

namespace glassbox::views {

// Sampson's distance: to first order, how far both points of a match together have to be moved so
// that p_r^T M p_l = 0 holds (Hartley and Zisserman, Multiple View Geometry, 11.4.3). It has a
// sign.
double sampson_distance(const Eigen::Matrix3d& matrix, const Match& match);

// The distance from each point of a match to the epipolar line of the other point; the mean of the
// two distances.
double epipolar_distance(const Eigen::Matrix3d& matrix, const Match& match);

// The transfer errors |H p_l - p_r| and |H^-1 p_r - p_l| of a homography H, combined: the square
// root of half the sum of their squares. `inverse` is H^-1.
double transfer_distance(const Eigen::Matrix3d& homography, const Eigen::Matrix3d& inverse,
                         const Match& match);

}  // namespace glassbox::views
