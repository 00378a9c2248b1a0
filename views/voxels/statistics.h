// Are these numbers one number with noise? Mean and variance without cancellation, and the law of the test (S1-19).
#pragma once

#include <cstdint>

namespace glassbox::views {

// Welford's recurrence (1962): the sum of squares is that of differences from the running mean, so it loses nothing to a mean that is
// far from 0 (C-93), and it cannot fall below 0.
struct Welford {
  std::int64_t count = 0;
  double mean = 0, squares = 0;  // squares: the sum of (x - mean)^2

  void add(double x) {
    ++count;
    const double before = x - mean;
    mean += before / double(count);
    squares += before * (x - mean);
  }
  // The unbiased one; 0 of fewer than two numbers.
  double variance() const { return count > 1 ? squares / double(count - 1) : 0; }
};

// Of whole numbers: every sum is exact, so is their difference, and no order matters. Three channels of 0 .. 1023 of up to 2^31
// pixels have room.
struct ColorSums {
  std::int64_t count = 0;
  std::int64_t channel[3] = {0, 0, 0};
  std::int64_t squares = 0;  // of all three

  void add(std::int64_t a, std::int64_t b, std::int64_t c) {
    ++count;
    channel[0] += a;
    channel[1] += b;
    channel[2] += c;
    squares += a * a + b * b + c * c;
  }
  void add(const ColorSums& other) {
    count += other.count;
    for (int i = 0; i < 3; ++i) channel[i] += other.channel[i];
    squares += other.squares;
  }
  // The sum over pixels and channels of (x - mean of its channel)^2: (K sum x^2 - (sum x)^2) / K, of which one division is rounded.
  double deviations() const;
  // Pooled over the channels: deviations() / (3 (K - 1)); 0 of fewer than two.
  double variance() const { return count > 1 ? deviations() / (3 * double(count - 1)) : 0; }
};

// The x that a chi-squared number with so many degrees of freedom exceeds with probability `tail`, 0 < tail < 1; to nine digits.
double chi_squared_quantile(double degrees, double tail);
// The probability that it exceeds x.
double chi_squared_tail(double degrees, double x);

}  // namespace glassbox::views
