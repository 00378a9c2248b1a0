#include <glassbox/base/rounding.h>

#include "study/extremes/common/extreme_case.h"
#include "study/scenes/two_cameras.h"

namespace glassbox::study {
namespace c109 {

constexpr double kSigma = 0.5, kDepth = 5;

// Predicts the standard deviation of the depth of a point.
using PredictedError = double (*)(const views::StereoRig& rig);

double by_covariance(const views::StereoRig& rig) {
  const double variance = views::covariance_of({0, 0, kDepth}, rig, kSigma)(2, 2);
  return std::isinf(variance) ? variance : std::sqrt(variance);
}
// Concludes wrongly: the projection of a point differs little from its pixels, so the point must be
// accurate.
double by_reprojection(const views::StereoRig&) {
  return kDepth * kSigma / 800;
}
double with_root_of_baseline(const views::StereoRig& rig) {
  return kDepth * kDepth * std::sqrt(2.0) * kSigma / 800 / std::sqrt(rig.pose.translation.norm());
}
double never_infinite(const views::StereoRig& rig) {
  const double said = by_covariance(rig);
  return std::isinf(said) ? 0 : said;
}

// The formula for parallel cameras holds for small angles, with a relative error of about (B/Z)^2,
// for the baseline B and the depth Z. The predicted error comes from the inverse of a matrix with a
// condition number of (Z/B)^2.
Outcome measure_error(PredictedError predicted_error) {
  WorstError worst;
  for (const double baseline : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    const double law = views::depth_error_of_parallel(kDepth, kSigma, 800, baseline);
    const double ratio = baseline / kDepth, condition = 1 / (ratio * ratio);
    worst.add(std::abs(predicted_error(rig_at({baseline, 0, 0})) / law - 1),
              4 * ratio * ratio + 16 * unit_roundoff<double> * condition,
              fmt::format("baseline {}", baseline), condition);
  }
  const bool said = std::isinf(predicted_error(rig_at({0, 0, 0})));
  worst.add(said ? 0 : 1, 0, "without a baseline the result does not say that there is no depth");
  return worst.outcome();
}

}  // namespace c109

ExtremeCase c109_no_baseline() {
  using namespace c109;
  return {
      .id = "C-109",
      .name = "A baseline that goes to 0",
      .construction =
          "a point at the distance 5, a noise of 1/2 px, baselines from 0.1 to 1e-6, and none",
      .stage = "two views",
      .right_answer =
          "the standard deviation of the depth is Z^2 sqrt(2) sigma/(f B), to 4 (B/Z)^2 for the "
          "angle and 16 u (Z/B)^2 for the inverse; without a baseline it is infinite",
      .unit = "relative",
      .oracle = Oracle::kAnalytic,
      .ours = {"the covariance of the point", [] { return measure_error(by_covariance); }},
      .naive = {"the point's error is computed from the reprojection error alone",
                [] { return measure_error(by_reprojection); }},
      .mutants = {{"the square root of the baseline in place of the baseline",
                   [] { return measure_error(with_root_of_baseline); }},
                  {"without a baseline the error is 0",
                   [] { return measure_error(never_infinite); }}},
      .not_drawn = "the result is computed from matches of points; no engine draws it",
  };
}

}  // namespace glassbox::study
