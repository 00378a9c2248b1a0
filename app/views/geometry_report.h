// What the geometry of two views says of one pair: the analysis, what follows from it, how far it is from the truth where there is
// one, and what is left out.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/views/geometry_input.h"
#include "views/two_view/analysis.h"

#include <glassbox/base/error.h>

namespace glassbox::app {

// What the command line leaves open.
struct GeometryQuestion {
  std::optional<views::Estimator> estimator;  // absent: five points where K is known, else eight
  double sigma = 0.5;                         // px: what a coordinate of a match may be off
  std::optional<double> threshold;            // px, of an inlier; absent: 2 sigma
  double confidence = 0.99;                   // that one sample has no outlier
  std::uint32_t seed = 1;                     // of the samples, and of noise and outliers
};

// Of the inliers' residuals, px.
struct ResidualFacts {
  double rms = 0, median = 0, largest = 0;
};

// One of the four poses that an E allows (C-105).
struct PoseCandidate {
  views::RelativePose pose;
  int in_front = 0;  // of the inliers, of both cameras
  bool is_chosen = false;
};

struct PoseErrors {
  double rotation_degrees = 0;
  std::optional<double> direction_degrees;  // absent: the cameras stand in one place
};

// Against matches that are known to be outliers.
struct OutlierFacts {
  int planted = 0;
  int kept = 0;  // of them, among the inliers: near their epipolar line by chance
  int lost = 0;  // true matches that are no inliers
};

struct LeftOut {
  std::string what, why;
};

struct GeometryReport {
  views::PairQuestion question;
  views::PairAnalysis analysis;
  double samples_wanted = 0;  // RANSAC's law, of the share of inliers that was found

  std::optional<views::Matrix3d> essential, essential_of_shift;  // R S, and [t]x R with t = -R T
  std::optional<std::array<views::Vector3d, 2>> epipoles;        // left, right; homogeneous
  std::vector<double> epipolar_distances;  // of all matches, px: to the lines, mean of both
  ResidualFacts sampson, epipolar;
  std::vector<PoseCandidate> candidates;  // empty without a pose
  std::optional<PoseErrors> errors;
  std::optional<OutlierFacts> outliers;
  std::vector<LeftOut> left_out;

  bool has_geometry() const { return analysis.fundamental.has_value(); }
};

// Refused: fewer than 8 matches that differ, an estimator that the cameras do not allow, and what `analyse` refuses.
Result<GeometryReport> report_geometry(const GeometryInput& input,
                                       const GeometryQuestion& question);

}  // namespace glassbox::app
