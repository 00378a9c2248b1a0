#include <glassbox/base/random.h>

#include "study/extremes/common/extreme_case.h"
#include "views/voxels/statistics.h"

namespace glassbox::study {
namespace c93 {

constexpr int kCount = 1000;
using VarianceOf = double (*)(const std::vector<double>& numbers);

double by_welford(const std::vector<double>& numbers) {
  views::Welford welford;
  for (const double x : numbers) welford.add(x);
  return welford.variance();
}
// The variance as E[x^2] - E[x]^2: the difference of two numbers near 62500, which is only 3e-5.
template <class T>
double variance_by_two_means(const std::vector<double>& numbers) {
  T sum = 0, squares = 0;
  for (const double x : numbers) {
    sum += T(x);
    squares += T(x) * T(x);
  }
  const T mean = sum / T(kCount);
  return double((squares - T(kCount) * mean * mean) / T(kCount - 1));
}
// A wrong version of Welford's method: uses the mean that already includes x in both factors.
double by_the_new_mean(const std::vector<double>& numbers) {
  double mean = 0, squares = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    mean += (numbers[i] - mean) / double(i + 1);
    squares += (numbers[i] - mean) * (numbers[i] - mean);
  }
  return squares / (kCount - 1);
}

Outcome measure_error(VarianceOf variance_of) {
  WorstError worst;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    std::vector<double> numbers;
    for (int i = 0; i < kCount; ++i) numbers.push_back(250 + random.between(-0.01, 0.01));
    long double mean = 0, squares = 0;
    for (const double x : numbers) mean += static_cast<long double>(x) / kCount;
    for (const double x : numbers) squares += (x - mean) * (x - mean);
    const double right = double(squares / (kCount - 1));
    // The relative error of Welford's method is at most n u kappa, for n numbers and the unit
    // roundoff u, with kappa = sqrt(1 + (mean / sigma)^2); see Chan, Golub and LeVeque 1983.
    const double kappa = std::sqrt(1 + 250 * 250 / right);
    worst.add(std::abs(variance_of(numbers) - right) / right, kCount * 0x1p-53 * kappa,
              fmt::format("seed {}", seed), kappa);
  }
  return worst.outcome();
}

}  // namespace c93

ExtremeCase c93_variance() {
  using namespace c93;
  return {
      .id = "C-93",
      .name = "The deviation of bright colours",
      .construction = "1000 numbers within 0.01 of 250, 20 times",
      .stage = "voxels",
      .right_answer =
          "the variance is right to n u kappa, where kappa = mean / sigma (Chan, Golub and LeVeque "
          "1983)",
      .unit = "relative",
      .oracle = Oracle::kExtended,
      .ours = {"Welford's update", [] { return measure_error(by_welford); }},
      .naive = {"E[x^2] - E[x]^2 in float",
                [] { return measure_error(variance_by_two_means<float>); }},
      .mutants = {{"E[x^2] - E[x]^2 in double",
                   [] { return measure_error(variance_by_two_means<double>); }},
                  {"both factors of the update use the new mean",
                   [] { return measure_error(by_the_new_mean); }}},
      .not_drawn = "the case reconstructs a shape from given pictures; no engine draws the result",
  };
}

}  // namespace glassbox::study
