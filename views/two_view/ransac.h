// RANSAC, a method for data with outliers (Fischler and Bolles, CACM 24, 1981): a model is fitted
// to random samples of as few matches as determine it, until one sample was probably free of
// outliers.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "views/two_view/match.h"

namespace glassbox::views {

// The number of samples of `size` matches after which one of them has no outlier with the
// probability `confidence`, if the fraction `inlier_share` of the matches are inliers: log(1 -
// confidence)/log(1 - inlier_share^size), at least 1. For half of the matches and 0.99 it is 145
// for samples of 5, and 1177 for samples of 8.
double samples_needed(double inlier_share, int size, double confidence);

struct RansacOptions {
  double threshold = 1;      // largest residual of an inlier
  double confidence = 0.99;  // probability that one sample has no outlier
  int most_samples = 10000;
  std::uint64_t seed = 1;
};

struct RansacModel {
  int sample_size = 8;
  // All models that fit a sample; none for a degenerate one.
  std::function<std::vector<Eigen::Matrix3d>(const Matches& sample)> fit;
  std::function<double(const Eigen::Matrix3d& model, const Match& match)> residual;
  // Returns the best model near `model` for these matches, of which those with a residual far above
  // the threshold have no influence. Empty: models stay as they are fitted to the samples.
  std::function<Eigen::Matrix3d(const Eigen::Matrix3d& model, const Matches& matches,
                                double threshold)>
      improve = {};
};

struct RansacResult {
  Eigen::Matrix3d model = Eigen::Matrix3d::Zero();
  std::vector<bool> is_inlier;  // for each match
  int inliers = 0;
  int samples = 0;  // number of samples drawn
};

// Finds the model with the least sum of squared residuals, each limited to the square of the
// threshold (Torr and Zisserman, MLESAC, CVIU 78, 2000). The same seed gives the same samples on
// every machine. No result if no sample has a model, or if there are fewer matches than a sample
// needs.
//
// If the model has `improve`, each sample that is better than all samples before it is improved
// with all matches (with some thousand of them if there are more). The sum has many local minima,
// so the search goes on from the best one: models of larger samples of its inliers are improved,
// too (Chum, Matas, Kittler, Locally Optimized RANSAC, DAGM 2003).
std::optional<RansacResult> ransac(const Matches& matches, const RansacModel& model,
                                   const RansacOptions& options);

Matches inliers_of(const Matches& matches, const std::vector<bool>& is_inlier);

}  // namespace glassbox::views
