// The complete two-view analysis of one list of matches.
#pragma once

#include <optional>
#include <vector>

#include <glassbox/base/error.h>

#include "views/two_view/estimate.h"
#include "views/two_view/pair_kind.h"
#include "views/two_view/plane_pose.h"

namespace glassbox::views {

struct PairRequest {
  Matches matches;  // pixels
  // For the left and the right camera. Without intrinsics only F can be found, and no pose.
  std::optional<std::array<Matrix3d, 2>> intrinsics;
  // The algorithm; without intrinsics, it must be one with eight or seven points.
  Estimator estimator = Estimator::kFivePoint;
  double sigma = 0.5;  // px: standard deviation of a coordinate of a match
  RansacOptions ransac;
};

// Properties of the linear system of the eight-point algorithm for the inliers.
struct SystemFacts {
  int rank = 0;  // at most 8
  double condition_raw = 0, condition_normalised = 0;
};

struct PairAnalysis {
  std::vector<bool> is_inlier;
  int inliers = 0, samples = 0;
  SystemFacts system;
  PairClassification classification;
  // F. Absent for a camera that only turned, and for a critical surface; for a plane it is only
  // present if intrinsics and five points determine it.
  std::optional<Matrix3d> fundamental;
  std::optional<RelativePose> pose;  // present only with intrinsics; |T| is 1
  // For a plane, if intrinsics and five points determine the pose: the pose above is that of the
  // first of its two solutions.
  std::optional<PlaneAnalysis> plane;
  int in_front = 0;  // inliers in front of both cameras
  // Only for five points: the points seem to be on a critical surface, of which two F are possible,
  // but with intrinsics only one E is.
  bool is_only_essential = false;
  // The error of the estimation, if the random samples gave no model or no pose, and the
  // classification explains why.
  std::optional<Error> why_no_model;
  std::vector<double> residuals;  // for all matches: Sampson's distance, px; empty without F
  double rms = 0;                 // of the inliers' residuals
};

// Inliers are found with the threshold of the request's RANSAC options. An error for fewer than 8
// matches, and if no model is found.
Result<PairAnalysis> analyse(const PairRequest& request);

// The left and the right epipole, e and e': the point where all epipolar lines of a picture meet,
// which is the image of the other camera's centre. Homogeneous, of length 1. F e = 0, F^T e' = 0.
Vector3d epipole_left(const Matrix3d& fundamental);
Vector3d epipole_right(const Matrix3d& fundamental);

}  // namespace glassbox::views
