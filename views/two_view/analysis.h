// All that two-view geometry says of one list of matches.
#pragma once

#include <optional>
#include <vector>

#include <glassbox/base/error.h>

#include "views/two_view/estimate.h"
#include "views/two_view/model.h"

namespace glassbox::views {

struct PairQuestion {
  Matches matches;  // pixels
  // Without them F alone can be found, and no pose.
  std::optional<std::array<Matrix3d, 2>> intrinsics;  // left, right
  Estimator estimator = Estimator::kFivePoint;        // eight or seven points without intrinsics
  double sigma = 0.5;                                 // px: what a coordinate of a match may be off
  RansacOptions ransac;
};

// Of the system of eight-point equations of the inliers.
struct SystemFacts {
  int rank = 0;  // of 8
  double condition_raw = 0, condition_normalised = 0;
};

struct PairAnalysis {
  std::vector<bool> is_inlier;
  int inliers = 0, samples = 0;
  SystemFacts system;
  PairJudgement judgement;
  // None of a camera that only turned, and of a critical surface; of a plane only where intrinsics and five points decide it.
  std::optional<Matrix3d> fundamental;
  std::optional<RelativePose> pose;  // with intrinsics; |T| is 1
  int in_front = 0;                  // of the inliers, of both cameras
  // What kept the samples from a model, or a pose, where the judgement says why.
  std::optional<Error> why_no_model;
  std::vector<double> residuals;  // of all matches: Sampson's distance, px; empty without F
  double rms = 0;                 // of the inliers'
};

// The threshold of an inlier is the question's RANSAC's. An error for fewer than 8 matches, and where no model is found.
Result<PairAnalysis> analyse(const PairQuestion& question);

// Where all epipolar lines of a picture meet, homogeneous, of length 1: the other camera's place. F e = 0, F^T e' = 0.
Vector3d epipole_left(const Matrix3d& fundamental);
Vector3d epipole_right(const Matrix3d& fundamental);

}  // namespace glassbox::views
