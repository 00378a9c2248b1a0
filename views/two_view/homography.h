// Homographies, the alternative to the epipolar constraint: p_r = H p_l up to scale for all points.
// This holds for points on a plane, and for a camera that only turns.
#pragma once

#include <vector>

#include <Eigen/Core>

#include <glassbox/base/error.h>

#include "views/two_view/match.h"

namespace glassbox::views {

// The least squares solution for four or more matches, computed with normalised points; the result
// has det H > 0 and Frobenius norm 1.
Result<Eigen::Matrix3d> fit_homography(const Matches& matches);

// The homography that most matches agree with, refined by these. A match agrees if its transfer
// residual (residual.h) is at most `threshold` pixels long. Outliers may be among the matches; a
// homography of fewer than half of them may be missed.
struct HomographyEstimate {
  Eigen::Matrix3d homography = Eigen::Matrix3d::Identity();
  std::vector<bool> is_inlier;
  int inliers = 0;
};
Result<HomographyEstimate> estimate_homography(const Matches& pixels, double threshold);

// Which matches agree with a homography, as above.
std::vector<bool> matches_within(double threshold, const Eigen::Matrix3d& homography,
                                 const Matches& pixels);

}  // namespace glassbox::views
