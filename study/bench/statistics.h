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

// Whether `a` is faster for certain: seven eighths of its times are below seven eighths of the
// times of `b`, so that three quarters of the times of each (between its octiles) do not overlap. A
// core that is shared with another program has two speeds. If two works of 21 rounds are equally
// fast, the probability that one meets the fast speed in 16 rounds or more and the other meets the
// slow one as often is 0.013^2: with quartiles, one in several thousand such pairs would be ordered
// wrongly, and a study has that many pairs. With 19 rounds of 21 it is one in 10^8.
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
// kLeastFitted points or more is reported.
inline constexpr std::size_t kLeastFitted = 3;
PowerLaw fit_power_law(std::span<const Sample> samples);

// Two power laws that meet at `at`, an x of the samples that belongs to both sides.
struct Bend {
  double at = 0;
  PowerLaw before, after;
};
// The bend with the least sum of squares; each side has three samples or more (x ascending), and
// the sample at the bend counts on both. None if the exponents differ by less than 0.1, or if the
// sum of squares is more than half of that of a single law.
std::optional<Bend> find_bend(std::span<const Sample> samples);

}  // namespace glassbox::study
