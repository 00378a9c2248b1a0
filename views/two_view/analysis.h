// The complete two-view analysis of one list of matches.
#pragma once

#include <optional>
#include <vector>

#include <glassbox/base/error.h>

#include "views/two_view/estimate.h"
#include "views/two_view/pair_kind.h"

namespace glassbox::views {

struct PairRequest {
  Matches matches;  // pixels
  // Without intrinsics only F can be found, and no pose.
  std::optional<std::array<Matrix3d, 2>> intrinsics;  // left, right
  Estimator estimator = Estimator::kFivePoint;        // without intrinsics: eight or seven points
  double sigma = 0.5;  // px: standard deviation of a coordinate of a match
  RansacOptions ransac;
};

// Properties of the system of eight-point equations of the inliers.
struct SystemFacts {
  int rank = 0;  // at most 8
  double condition_raw = 0, condition_normalised = 0;
};

struct PairAnalysis {
  std::vector<bool> is_inlier;
  int inliers = 0, samples = 0;
  SystemFacts system;
  PairClassification classification;
  // Absent for a camera that only turned, and for a critical surface; for a plane it is only
  // present if intrinsics and five points determine it.
  std::optional<Matrix3d> fundamental;
  std::optional<RelativePose> pose;  // with intrinsics; |T| is 1
  int in_front = 0;                  // inliers in front of both cameras
  // Why the samples gave no model, or no pose, if the classification explains it.
  std::optional<Error> why_no_model;
  std::vector<double> residuals;  // for all matches: Sampson's distance, px; empty without F
  double rms = 0;                 // of the inliers' residuals
};

// Inliers are found with the threshold of the request's RANSAC options. An error for fewer than 8
// matches, and if no model is found.
Result<PairAnalysis> analyse(const PairRequest& request);

// The epipoles: the point where all epipolar lines of a picture meet, which is the image of the
// other camera's centre. Homogeneous, of length 1. F e = 0, F^T e' = 0.
Vector3d epipole_left(const Matrix3d& fundamental);
Vector3d epipole_right(const Matrix3d& fundamental);

}  // namespace glassbox::views
