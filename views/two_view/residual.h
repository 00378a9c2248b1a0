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

// How far p_r is from H p_l for a homography H, in a frame in which errors of all four coordinates
// count alike. Its length is Sampson's distance for the two equations of a homography: to first
// order, how far both points of a match together have to be moved so that p_r = H p_l.
Eigen::Vector2d transfer_residual(const Eigen::Matrix3d& homography, const Match& match);

}  // namespace glassbox::views
