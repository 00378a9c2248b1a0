// The complete estimation of a matrix, or a relative pose, from matches with outliers: first with
// random samples, then with all matches that agree with the best sample's model.
#pragma once

#include <vector>

#include <glassbox/base/error.h>

#include "views/two_view/ransac.h"
#include "views/two_view/triangulation.h"

namespace glassbox::views {

enum class Estimator { kEightPoint, kSevenPoint, kFivePoint };
inline constexpr Estimator kEstimators[] = {Estimator::kEightPoint, Estimator::kSevenPoint,
                                            Estimator::kFivePoint};
const char* name_of(Estimator estimator);
int sample_size(Estimator estimator);

// The RANSAC model of an estimator: F from pixels (eight or seven points), or E from calibrated
// points (eight or five), with Sampson's distance as the residual.
RansacModel ransac_model(Estimator estimator);

struct FundamentalEstimate {
  Matrix3d fundamental;
  std::vector<bool> is_inlier;
  int inliers = 0, samples = 0;
};

struct PoseEstimate {
  RelativePose pose;  // |T| is 1
  std::vector<bool> is_inlier;
  int inliers = 0, samples = 0;
  int in_front = 0;  // inliers in front of both cameras
};

// Both functions estimate from pixels; the threshold is in pixels. First, the best model of the
// random samples is found. Then a refined model selects its inliers again, until they no longer
// change. An error if no sample has a model, if fewer than 8 inliers are left, or if the pose is
// ambiguous because as many points are behind the cameras as in front of them.
Result<FundamentalEstimate> estimate_fundamental(const Matches& pixels, Estimator estimator,
                                                 const RansacOptions& options);
Result<PoseEstimate> estimate_pose(const Matches& pixels, const Matrix3d& left_intrinsic,
                                   const Matrix3d& right_intrinsic, Estimator estimator,
                                   const RansacOptions& options);

// Which matches have a Sampson distance of at most `threshold`.
std::vector<bool> matches_near(const Matrix3d& fundamental, const Matches& pixels,
                               double threshold);

// The matches as points on the plane at distance 1 in front of each camera.
Matches calibrated(const Matches& pixels, const Matrix3d& left_intrinsic,
                   const Matrix3d& right_intrinsic);

}  // namespace glassbox::views
