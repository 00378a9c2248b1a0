#include "study/extremes/common/extreme_case.h"
#include "study/scenes/two_cameras.h"

namespace glassbox::study {
namespace c108 {

// Predicts the standard deviation of the depth for noise of `sigma` px.
using PredictedError = double (*)(const views::Vector3d& point, const views::StereoRig& rig,
                                  double sigma);

double by_covariance(const views::Vector3d& point, const views::StereoRig& rig, double sigma) {
  return std::sqrt(views::covariance_of(point, rig, sigma)(2, 2));
}
// Uses the formula for parallel cameras, whatever the direction of the baseline is.
double by_parallel_law(const views::Vector3d& point, const views::StereoRig& rig, double sigma) {
  return views::depth_error_of_parallel(point.z(), sigma, 800, rig.pose.translation.norm());
}
double one_picture_alone(const views::Vector3d& point, const views::StereoRig& rig, double sigma) {
  return by_covariance(point, rig, sigma) / std::sqrt(2.0);
}
// Uses the sine of the angle at the camera between baseline and line of sight, instead of the angle
// at the point between both lines of sight.
double by_sine_at_camera(const views::Vector3d& point, const views::StereoRig& rig, double sigma) {
  const double sine = point.head<2>().norm() / point.norm();
  return by_parallel_law(point, rig, sigma) / std::sqrt(sine);
}

constexpr int kSamples = 4000;

// Compares the prediction with the standard deviation over n = 4000 noisy pairs of pixels. The
// measured deviation has a relative standard error of 1/sqrt(2 n), and four times that is allowed.
// The noise is so small that the depth is linear in it.
Outcome measure_error(PredictedError predicted_error) {
  Random random(108);
  constexpr double kSigma = 0.01, kBound = 0.0447;  // 4/sqrt(8000)
  const views::StereoRig rig = rig_at({0, 0, 1});
  WorstError worst;
  for (const double aside : {0.02, 0.05, 0.1, 0.3}) {
    const views::Vector3d point(5 * aside, 2 * aside, 5);
    double sum = 0, squares = 0;
    for (int i = 0; i < kSamples; ++i) {
      const views::Match pixels = project_match(rig, point, kSigma, random);
      const double off =
          views::triangulate(views::Triangulator::kLindstrom, pixels, rig).point.z() - point.z();
      sum += off;
      squares += off * off;
    }
    const double measured = std::sqrt((squares - sum * sum / kSamples) / (kSamples - 1));
    const double said = predicted_error(point, rig, kSigma);
    worst.add(
        std::abs(said / measured - 1), kBound,
        fmt::format("at {:.2g} of the distance from the epipole: {:.3g} measured, {:.3g} predicted",
                    aside, measured, said));
  }
  return worst.outcome();
}

}  // namespace c108

ExtremeCase c108_near_epipole() {
  using namespace c108;
  return {
      .id = "C-108",
      .name = "Points near the epipole",
      .construction =
          "a camera that moves 1 ahead, points at the distance 5 and 0.02 to 0.3 of it to the "
          "side; 4000 pairs of pixels each, with a noise of 1/100 px",
      .stage = "two views",
      .right_answer =
          "the standard deviation of the depth follows from (J^T J)^-1, to 4/sqrt(8000), where J "
          "has the derivatives of the pixels with respect to the point; it grows without bound "
          "towards the epipole",
      .unit = "relative",
      .oracle = Oracle::kAnalytic,
      .ours = {"the covariance of the point", [] { return measure_error(by_covariance); }},
      .naive = {"Z^2 sqrt(2) sigma/(f B)", [] { return measure_error(by_parallel_law); }},
      .mutants = {{"only the noise of one picture is counted",
                   [] { return measure_error(one_picture_alone); }},
                  {"divided by the sine of the angle at the camera",
                   [] { return measure_error(by_sine_at_camera); }}},
      .not_drawn = "the result is computed from matches of points; no engine draws it",
  };
}

}  // namespace glassbox::study
