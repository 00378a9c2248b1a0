// Numbers out of many measurements.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace glassbox::study {

// Of one value or more; between two neighbours where the count asks for it (linear, Hyndman and Fan's type 7).
struct Quartiles {
  double lower = 0, median = 0, upper = 0;
  double first_octile = 0;  // an eighth of the values is less
  double last_octile = 0;   // an eighth is more
};
Quartiles quartiles(std::vector<double> values);

// Whether three quarters of the times of one lie apart from three quarters of the other's. A core that is shared with another program
// has two speeds. Of two equal works of 21 rounds, the one meets the fast speed in 16 or more and the other the slow one with
// the probability 0.013^2: quartiles would order one in some thousand such pairs, and a study has as many. With 19 rounds of
// 21 it is one in 10^8.
inline bool is_faster(const Quartiles& a, const Quartiles& b) {
  return a.last_octile < b.first_octile;
}

inline double median(std::vector<double> values) {
  return quartiles(std::move(values)).median;
}

struct Sample {
  double x = 0, y = 0;  // both above 0
};

// y = factor * x^exponent, by least squares of the logarithms.
struct PowerLaw {
  double factor = 0, exponent = 0;
  double squares = 0;  // what is left of the logarithms' squares
};
// At least two different x. Through two points any law goes: what is reported is fitted to kLeastFitted or more.
inline constexpr std::size_t kLeastFitted = 3;
PowerLaw fit_power_law(std::span<const Sample> samples);

// Two power laws, one on either side of `at`, an x of the samples that belongs to both.
struct Bend {
  double at = 0;
  PowerLaw before, after;
};
// The bend that leaves the least squares, of three samples or more (x ascending) on either side, the shared one among
// them. None where the exponents differ by less than 0.1, or the bend leaves more than half of what one law leaves.
std::optional<Bend> find_bend(std::span<const Sample> samples);

}  // namespace glassbox::study
