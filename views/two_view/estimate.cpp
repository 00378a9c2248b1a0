#include "views/two_view/estimate.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "views/two_view/linear_fit.h"
#include "views/two_view/minimal_solvers.h"
#include "views/two_view/pose.h"
#include "views/two_view/refinement.h"
#include "views/two_view/residual.h"

namespace glassbox::views {

namespace {

constexpr int kMaxRounds = 20;

int count(const std::vector<bool>& chosen) {
  return int(std::ranges::count(chosen, true));
}

tl::unexpected<Error> no_model(int matches) {
  return fail(
      "the matches",
      fmt::format("the relation between the two pictures cannot be computed from these {} matches",
                  matches),
      "give more matches, whose points are not all in one plane or on one line");
}

tl::unexpected<Error> few_inliers(int inliers, double threshold) {
  return fail(
      "the matches",
      fmt::format("only {} of them agree with the same two cameras within {} px, but 8 are needed",
                  inliers, threshold),
      "give more accurate matches, or a larger threshold");
}

// `refine(model, inliers)` returns a better model. The inliers are selected again with its F, until
// they no longer change.
template <class Model, class Refine, class FundamentalOf>
void refine_until_stable(const Matches& pixels, double threshold, const Refine& refine,
                         const FundamentalOf& fundamental, Model& model,
                         std::vector<bool>& is_inlier) {
  for (int round = 0; round < kMaxRounds && count(is_inlier) >= 8; ++round) {
    model = refine(model, inliers_of(pixels, is_inlier));
    std::vector<bool> next = matches_near(fundamental(model), pixels, threshold);
    if (next == is_inlier) break;
    is_inlier = std::move(next);
  }
}

// The RANSAC model of an estimator, whose models are improved by the matches near them.
RansacModel improving_model(Estimator estimator, bool is_calibrated) {
  RansacModel model = ransac_model(estimator);
  model.improve = [=](const Matrix3d& matrix, const Matches& matches, double threshold) {
    if (!is_calibrated) return refined_fundamental(matrix, matches, threshold);
    StereoRig rig;
    rig.pose = poses_of(nearest_essential(matrix))[0];  // the other three have the same residuals
    rig.pose = refined_pose(rig, matches, threshold);
    return fundamental_of(rig);
  };
  return model;
}

}  // namespace

const char* name_of(Estimator estimator) {
  switch (estimator) {
    case Estimator::kEightPoint:
      return "8-point";
    case Estimator::kSevenPoint:
      return "7-point";
    case Estimator::kFivePoint:
      return "5-point";
  }
  return "";
}

int sample_size(Estimator estimator) {
  switch (estimator) {
    case Estimator::kEightPoint:
      return 8;
    case Estimator::kSevenPoint:
      return 7;
    case Estimator::kFivePoint:
      break;
  }
  return 5;
}

RansacModel ransac_model(Estimator estimator) {
  RansacModel model;
  model.sample_size = sample_size(estimator);
  model.residual = sampson_distance;
  switch (estimator) {
    case Estimator::kEightPoint:
      model.fit = [](const Matches& sample) -> std::vector<Matrix3d> {
        const auto fit = fit_fundamental(sample, Conditioning::kNormalised);
        return fit && fit->system.rank() == 8 ? std::vector{fit->matrix} : std::vector<Matrix3d>{};
      };
      break;
    case Estimator::kSevenPoint:
      model.fit = [](const Matches& sample) {
        return seven_point(sample).value_or(std::vector<Matrix3d>{});
      };
      break;
    case Estimator::kFivePoint:
      model.fit = [](const Matches& sample) {
        return five_point(sample).value_or(std::vector<Matrix3d>{});
      };
      break;
  }
  return model;
}

Matches calibrated(const Matches& pixels, const Matrix3d& left_intrinsic,
                   const Matrix3d& right_intrinsic) {
  Matches result;
  for (const Match& match : pixels) {
    const Rays rays = rays_of(match, left_intrinsic, right_intrinsic);
    result.push_back({rays.left.head<2>(), rays.right.head<2>()});
  }
  return result;
}

std::vector<bool> matches_near(const Matrix3d& fundamental, const Matches& pixels,
                               double threshold) {
  std::vector<bool> is_near;
  for (const Match& match : pixels) {
    is_near.push_back(std::abs(sampson_distance(fundamental, match)) <= threshold);
  }
  return is_near;
}

Result<FundamentalEstimate> estimate_fundamental(const Matches& pixels, Estimator estimator,
                                                 const RansacOptions& options) {
  const auto found = ransac(pixels, improving_model(estimator, false), options);
  if (!found) return no_model(int(pixels.size()));
  FundamentalEstimate estimate{found->model, found->is_inlier, 0, found->samples};
  refine_until_stable(
      pixels, options.threshold,
      [](const Matrix3d& f, const Matches& good) { return refined_fundamental(f, good); },
      [](const Matrix3d& f) { return f; }, estimate.fundamental, estimate.is_inlier);
  estimate.inliers = count(estimate.is_inlier);
  if (estimate.inliers < 8) return few_inliers(estimate.inliers, options.threshold);
  return estimate;
}

Result<PoseEstimate> estimate_pose(const Matches& pixels, const Matrix3d& left_intrinsic,
                                   const Matrix3d& right_intrinsic, Estimator estimator,
                                   const RansacOptions& options) {
  const Matches matches = calibrated(pixels, left_intrinsic, right_intrinsic);
  RansacOptions there = options;
  there.threshold /= std::min(left_intrinsic(1, 1), right_intrinsic(1, 1));
  const auto found = ransac(matches, improving_model(estimator, true), there);
  if (!found) return no_model(int(pixels.size()));
  const auto chosen =
      pose_in_front(nearest_essential(found->model), inliers_of(matches, found->is_inlier));
  if (!chosen) {
    return fail("the matches", "as many of their points are behind the cameras as in front of them",
                "give matches of nearer points, or pictures from places further apart");
  }
  PoseEstimate estimate{chosen->pose, found->is_inlier, 0, found->samples, 0};
  const auto rig = [&](const RelativePose& pose) {
    return StereoRig{left_intrinsic, right_intrinsic, pose};
  };
  refine_until_stable(
      pixels, options.threshold,
      [&](const RelativePose& pose, const Matches& good) { return refined_pose(rig(pose), good); },
      [&](const RelativePose& pose) { return fundamental_of(rig(pose)); }, estimate.pose,
      estimate.is_inlier);
  estimate.inliers = count(estimate.is_inlier);
  if (estimate.inliers < 8) return few_inliers(estimate.inliers, options.threshold);
  estimate.in_front = in_front_of_both(estimate.pose, inliers_of(matches, estimate.is_inlier));
  return estimate;
}

}  // namespace glassbox::views
