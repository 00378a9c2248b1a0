// Compares random sampling (RANSAC) of five, seven and eight matches with outliers, and the
// conditioning of eight points with and without normalising (D-22).
#include <algorithm>
#include <cmath>

#include "study/experiment/experiment.h"
#include "study/experiments/do_not_optimize.h"
#include "study/scenes/two_cameras.h"
#include "views/two_view/estimate.h"
#include "views/two_view/linear_fit.h"

namespace glassbox::study {
namespace d22 {

constexpr int kMatches = 200;

struct Problem {
  views::StereoRig rig;
  views::Matches pixels, calibrated;
};

// Matches with a noise of a tenth of a pixel, and outliers at random places in the right picture.
Problem problem(double outliers, std::uint64_t seed) {
  Random random(seed);
  Problem made{random_rig(random), {}, {}};
  made.pixels = matches_of(random, made.rig, kMatches, 0.1);
  for (int i = 0; i < int(std::lround(outliers * kMatches)); ++i) {
    const double x = random.between(0, 640);
    made.pixels[std::size_t(i)].right = {x, random.between(0, 480)};
  }
  made.calibrated = calibrated(made.pixels, made.rig);
  return made;
}

// The threshold of two pixels is far above the noise and far below the error of most outliers.
std::optional<views::RansacResult> sampled(const Problem& problem, views::Estimator estimator,
                                           std::uint64_t seed) {
  const bool by_five = estimator == views::Estimator::kFivePoint;
  const double threshold = by_five ? 2.0 / 800 : 2.0;
  return views::ransac(by_five ? problem.calibrated : problem.pixels,
                       views::ransac_model(estimator), {threshold, 0.99, 20000, seed});
}

double median_samples(double outliers, views::Estimator estimator, int runs) {
  std::vector<double> samples;
  for (int i = 0; i < runs; ++i) {
    const auto found = sampled(problem(outliers, 100 + std::uint64_t(i)), estimator, 7);
    samples.push_back(found ? double(found->samples) : double(INFINITY));
  }
  std::ranges::nth_element(samples, samples.begin() + runs / 2);
  return samples[std::size_t(runs / 2)];
}

// ---- the condition of eight points ----

double median_condition(int count, bool normalised) {
  Random random(22);
  std::vector<double> all;
  for (int i = 0; i < 101; ++i) {
    const views::StereoRig rig = random_rig(random);
    const views::Matches pixels = matches_of(random, rig, count, 0.5, 4, 8);
    const auto fit = normalised ? views::linear_fit(views::normalised(pixels)->matches)
                                : views::linear_fit(pixels);
    all.push_back(fit->condition());
  }
  std::ranges::nth_element(all, all.begin() + 50);
  return all[50];
}

struct Conditions {
  int matches;
  double raw, normalised;  // log10 of the condition number
};
// The condition numbers that the literature gives (B.8).
constexpr Conditions kConditions[] = {{8, 5.5, 2.3}, {20, 4.95, 1.8}, {50, 4.7, 1.6}};

std::vector<Configuration> configurations(Effort effort) {
  const int runs = effort == Effort::kQuick ? 5 : 21;
  std::vector<double> shares{0.1, 0.2, 0.3, 0.4, 0.5};
  std::vector<Configuration> all;
  for (const auto& [name, estimator] : {std::pair{"five points", views::Estimator::kFivePoint},
                                        std::pair{"seven points", views::Estimator::kSevenPoint},
                                        std::pair{"eight points", views::Estimator::kEightPoint}}) {
    for (const double outliers : shares) {
      const Problem timed = problem(outliers, 100);
      all.push_back(
          {.series = name,
           .parameter = outliers,
           .error = [=, e = estimator] { return median_samples(outliers, e, runs); },
           .predicted_error =
               views::samples_needed(1 - outliers, views::sample_size(estimator), 0.99),
           .work = [timed, e = estimator](int) { do_not_optimize(sampled(timed, e, 7)); }});
    }
  }
  for (const Conditions& known : kConditions) {
    for (const bool normalised : {false, true}) {
      all.push_back({.series = normalised ? "normalised points" : "pixels",
                     .parameter = double(known.matches),
                     .measure = "condition",
                     .error = [=] { return median_condition(known.matches, normalised); },
                     .predicted_error = std::pow(10, normalised ? known.normalised : known.raw),
                     .work =
                         [=](int) {
                           Random random(22);
                           const views::StereoRig rig = random_rig(random);
                           const views::Matches pixels =
                               matches_of(random, rig, known.matches, 0.5, 4, 8);
                           for (int i = 0; i < 20; ++i)
                             do_not_optimize(views::fit_fundamental(
                                 pixels, normalised ? views::Conditioning::kNormalised
                                                    : views::Conditioning::kRaw));
                         },
                     .items = 20});
    }
  }
  return all;
}

}  // namespace d22

Experiment d22_samples() {
  using namespace d22;
  return {.id = "D-22",
          .name = "Random samples against outliers",
          .question =
              "How many samples does a robust estimate of two cameras need, and what does it save "
              "to use five matches per sample?",
          .axis = "fraction of outliers",
          .logarithmic_axis = false,
          .error = "median number of samples until one without an outlier is likely enough",
          .reference =
              "200 matches with a noise of 1/10 px, and outliers anywhere; the threshold is 2 px",
          .theory =
              "log(0.01)/log(1 - w^k) samples are needed, where w is the fraction of inliers and k "
              "the number of matches per sample (Fischler and Bolles 1981); condition numbers are "
              "measured (B.8 in docs/references.md)",
          .item = "estimate",
          .measures = {{.name = "condition",
                        .error = "median condition number of the system of n matches",
                        .error_unit = "",
                        .axis = "matches"}},
          .configurations = configurations};
}

}  // namespace glassbox::study
