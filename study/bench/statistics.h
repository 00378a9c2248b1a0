// Summaries of many measurements: quartiles and fitted power laws.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace glassbox::study {

// The quartiles of one value or more; interpolated linearly between two neighbours where necessary
// (type 7 of Hyndman and Fan).
struct Quartiles {
  double lower = 0, median = 0, upper = 0;
  double first_octile = 0;  // an eighth of the values is less than this
  double last_octile = 0;   // an eighth of the values is greater than this
};
Quartiles quartiles(std::vector<double> values);

// Whether `a` is faster for certain: its last octile is below the first octile of `b`. Quartiles
// would not be enough: a processor core that is shared with another program has two speeds. Suppose
// that two equally fast works are timed 21 times each. If one of them runs at the fast speed 16
// times or more and the other as often at the slow speed, quartiles put them into a wrong order.
// The probability is 0.013^2, one in several thousand, and a study compares that many pairs. To
// mislead octiles it must be 19 times of 21, with a probability of one in 10^8.
inline bool is_faster(const Quartiles& a, const Quartiles& b) {
  return a.last_octile < b.first_octile;
}

inline double median(std::vector<double> values) {
  return quartiles(std::move(values)).median;
}

struct Sample {
  double x = 0, y = 0;  // both greater than 0
};

// y = factor * x^exponent, fitted by least squares of the logarithms.
struct PowerLaw {
  double factor = 0, exponent = 0;
  double squares = 0;  // sum of the squared residuals of the logarithms
};
// A fit needs at least two different x. Any two points lie on some power law, so only a fit to
// kMinFitted points or more is reported.
inline constexpr std::size_t kMinFitted = 3;
PowerLaw fit_power_law(std::span<const Sample> samples);

// Two power laws, for the samples before and after the bend. The bend is at the sample with x =
// `at`, which belongs to both sides.
struct Bend {
  double at = 0;
  PowerLaw before, after;
};
// Finds the bend with the least sum of squared residuals. The samples must be in ascending order of
// x; each side of the bend has three samples or more, including the sample at the bend. Returns
// nothing if the exponents differ by less than 0.1, or if the sum of squares is more than half of
// that of a single power law.
std::optional<Bend> find_bend(std::span<const Sample> samples);

}  // namespace glassbox::study
