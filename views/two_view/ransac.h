// Random samples against outliers (Fischler and Bolles, CACM 24, 1981): a model is fitted to as few matches as decide it, as often as
// it takes to have had a sample without an outlier.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "views/two_view/match.h"

namespace glassbox::views {

// log(1 - confidence)/log(1 - inliers^size): samples of `size` of which one has no outlier, with that probability, where that share
// of the matches are inliers. At least 1; 145 and 1177 for half of the matches, samples of 5 and 8 and 0.99.
double samples_needed(double inlier_share, int size, double confidence);

struct RansacOptions {
  double threshold = 1;      // of an inlier's residual
  double confidence = 0.99;  // that one sample has no outlier
  int most_samples = 10000;
  std::uint64_t seed = 1;
};

struct RansacModel {
  int sample_size = 8;
  // All models that a sample allows; none for a degenerate one.
  std::function<std::vector<Eigen::Matrix3d>(const Matches& sample)> fit;
  std::function<double(const Eigen::Matrix3d& model, const Match& match)> residual;
};

struct RansacResult {
  Eigen::Matrix3d model = Eigen::Matrix3d::Zero();
  std::vector<bool> is_inlier;  // of each match
  int inliers = 0;
  int samples = 0;  // that were drawn
};

// The model with the least sum of squared residuals, each at most the threshold's (Torr and Zisserman, MLESAC, CVIU 78, 2000). The
// same seed gives the same samples everywhere. None where no sample allows a model, or there are fewer matches than one needs.
std::optional<RansacResult> ransac(const Matches& matches, const RansacModel& model,
                                   const RansacOptions& options);

Matches inliers_of(const Matches& matches, const std::vector<bool>& is_inlier);

}  // namespace glassbox::views
