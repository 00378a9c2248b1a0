#include "study/extremes/common/extreme_case.h"
#include "study/naive/two_view.h"
#include "study/scenes/two_cameras.h"
#include "views/two_view/refinement.h"
#include "views/two_view/residual.h"

namespace glassbox::study {
namespace c99 {

constexpr int kPairs = 60, kMatches = 20;
constexpr double kNoise = 0.5;

using Estimator = views::Matrix3d (*)(const views::Matches& pixels);

views::Matrix3d by_normalised_points(const views::Matches& pixels) {
  const auto fit = views::fit_fundamental(pixels, views::Conditioning::kNormalised);
  return fit ? fit->matrix : views::Matrix3d::Zero();
}

// The mean distance of points without noise from their epipolar lines by a matrix that was
// estimated from points with noise.
double mean_distance(const views::Matrix3d& estimate, const views::Matches& clean) {
  double sum = 0;
  for (const views::Match& m : clean) sum += views::epipolar_distance(estimate, m);
  return sum / double(clean.size());
}

// The mean error over all pairs of cameras; the bound is twice the error of the best estimate from
// the same matches.
Outcome measure_error(Estimator estimator) {
  Random random(99);
  double error = 0, best = 0, condition = 0;
  for (int i = 0; i < kPairs; ++i) {
    const views::StereoRig rig = random_rig(random);
    const views::Matches clean = matches_of(random, rig, kMatches, 0, 4, 8);
    views::Matches noisy = clean;
    for (views::Match& m : noisy) {
      m.left += pixel_noise(random, kNoise);
      m.right += pixel_noise(random, kNoise);
    }
    const views::Matrix3d first = by_normalised_points(noisy);
    error += mean_distance(estimator(noisy), clean) / kPairs;
    best += mean_distance(views::refined_fundamental(first, noisy), clean) / kPairs;
    condition += std::log10(views::linear_fit(noisy)->condition()) / kPairs;
  }
  return {error, 2 * best, std::pow(10, condition),
          fmt::format("the error is {:.3g} px, and that of the best estimate is {:.3g} px", error,
                      best)};
}

}  // namespace c99

ExtremeCase c99_raw_pixels() {
  using namespace c99;
  return {
      .id = "C-99",
      .name = "Eight points in pixels",
      .construction = "60 pairs of cameras of 640 x 480, 20 matches with a noise of 1/2 px",
      .stage = "two views",
      .right_answer =
          "with normalised points (Hartley 1997) the distance from the true points to the epipolar "
          "lines is at most twice that of the estimate that minimises Sampson's distance for the "
          "same matches; the condition number is that of the raw system",
      .unit = "px",
      .oracle = Oracle::kProperty,
      .ours = {"the system is made from normalised points",
               [] { return measure_error(by_normalised_points); }},
      .naive = {"the system is made from raw pixel coordinates",
                [] { return measure_error(naive::fundamental_raw); }},
      .mutants = {{"F is transformed back with the two matrices exchanged",
                   [] { return measure_error(naive::fundamental_carried_back_crosswise); }},
                  {"F is not transformed back",
                   [] { return measure_error(naive::fundamental_not_carried_back); }}},
      .not_drawn = "the result is computed from matches of points; no engine draws it",
  };
}

}  // namespace glassbox::study
