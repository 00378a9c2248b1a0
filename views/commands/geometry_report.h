// The report on the geometry of two views: the analysis of the pair, what follows from it, its
// errors if the truth is known, and what is left out.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "views/commands/geometry_input.h"
#include "views/two_view/analysis.h"

#include <glassbox/base/error.h>

namespace glassbox::views {

// The parameters of the analysis.
struct GeometryQuestion {
  std::optional<views::Estimator> estimator;  // absent: five points if K is known, else eight
  double sigma = 0.5;                         // px: the expected error of a match's coordinate
  // px: the largest distance of an inlier; absent: 2 sigma
  std::optional<double> threshold;
  double confidence = 0.99;  // probability that at least one sample has no outlier
  std::uint32_t seed = 1;    // for the random samples, the noise and the outliers
};

// The inliers' residuals, px.
struct ResidualFacts {
  double rms = 0, median = 0, largest = 0;
};

// One of the four poses that the essential matrix E allows (C-105).
struct PoseCandidate {
  views::RelativePose pose;
  int in_front = 0;  // number of inliers in front of both cameras
  bool is_chosen = false;
};

struct PoseErrors {
  double rotation_degrees = 0;
  std::optional<double> direction_degrees;  // absent: both cameras are at the same position
};

// A comparison with matches that are known to be outliers.
struct OutlierFacts {
  int planted = 0;
  int kept = 0;  // outliers that count as inliers, being near their epipolar line by chance
  int lost = 0;  // true matches that do not count as inliers
};

struct LeftOut {
  std::string what, why;
};

struct GeometryReport {
  views::PairQuestion question;
  views::PairAnalysis analysis;
  double samples_wanted = 0;  // by RANSAC's law, from the share of inliers found

  std::optional<views::Matrix3d> essential, essential_of_shift;  // R S; and [t]x R with t = -R T
  std::optional<std::array<views::Vector3d, 2>> epipoles;        // left, right; homogeneous
  // px, of all matches: the mean of the distances to the two epipolar lines
  std::vector<double> epipolar_distances;
  ResidualFacts sampson, epipolar;
  std::vector<PoseCandidate> candidates;  // empty if no pose was found
  std::optional<PoseErrors> errors;
  std::optional<OutlierFacts> outliers;
  std::vector<LeftOut> left_out;

  bool has_geometry() const { return analysis.fundamental.has_value(); }
};

// Analyses the pair. Errors: fewer than 8 distinct matches, an estimator that needs cameras that
// are not known, and errors of `analyse`.
Result<GeometryReport> report_geometry(const GeometryInput& input,
                                       const GeometryQuestion& question);

}  // namespace glassbox::views
