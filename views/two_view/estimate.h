// The whole way from matches with outliers to a matrix, or a relative pose: samples, then all that agree with it.
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

// F from pixels (eight or seven points), or E from calibrated points (eight or five), with Sampson's distance as the residual.
RansacModel sampled(Estimator estimator);

struct FundamentalEstimate {
  Matrix3d fundamental;
  std::vector<bool> is_inlier;
  int inliers = 0, samples = 0;
};

struct PoseEstimate {
  RelativePose pose;  // |T| is 1
  std::vector<bool> is_inlier;
  int inliers = 0, samples = 0;
  int in_front = 0;  // of the inliers, of both cameras
};

// The threshold is in pixels. After the samples, the refined model chooses its inliers anew, until they stay. An error where no
// sample has a model, where fewer inliers are left than the refinement has unknowns, or where they lie as much behind the
// cameras as in front of them.
Result<FundamentalEstimate> estimate_fundamental(const Matches& pixels, Estimator estimator,
                                                 const RansacOptions& options);
Result<PoseEstimate> estimate_pose(const Matches& pixels, const Matrix3d& left_intrinsic,
                                   const Matrix3d& right_intrinsic, Estimator estimator,
                                   const RansacOptions& options);

// On the planes at distance 1.
Matches calibrated(const Matches& pixels, const Matrix3d& left_intrinsic,
                   const Matrix3d& right_intrinsic);

}  // namespace glassbox::views
