// Statistics for the question whether numbers are one number with noise: mean and variance without
// cancellation, and the distribution of the test (S1-19).
#pragma once

#include <cstdint>

namespace glassbox::views {

// Welford's recurrence (1962): it sums squared differences from the running mean, so a mean far
// from 0 costs no accuracy (C-93), and the sum cannot become negative.
struct Welford {
  std::int64_t count = 0;
  double mean = 0, squares = 0;  // squares: the sum of (x - mean)^2

  void add(double x) {
    ++count;
    const double before = x - mean;
    mean += before / double(count);
    squares += before * (x - mean);
  }
  // The unbiased variance; 0 for fewer than two numbers.
  double variance() const { return count > 1 ? squares / double(count - 1) : 0; }
};

// Sums of integers: every sum and difference is exact, and the order does not matter. There is room
// for up to 2^31 pixels with three channels of 0 .. 1023.
struct ColorSums {
  std::int64_t count = 0;
  std::int64_t channel[3] = {0, 0, 0};
  std::int64_t squares = 0;  // sum of the squares of all three channels

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
  // The sum over pixels and channels of (x - mean of its channel)^2. For a channel of K pixels it
  // is computed as (K sum x^2 - (sum x)^2) / K, where only the division is rounded.
  double deviations() const;
  // The variance pooled over the channels: deviations() / (3 (K - 1)) for K pixels; 0 for fewer
  // than two pixels.
  double variance() const { return count > 1 ? deviations() / (3 * double(count - 1)) : 0; }
};

// The number that a chi-squared variable with this many degrees of freedom exceeds with probability
// `tail`, 0 < tail < 1; to nine digits.
double chi_squared_quantile(double degrees, double tail);
// The probability that a chi-squared variable with this many degrees of freedom exceeds x.
double chi_squared_tail(double degrees, double x);

}  // namespace glassbox::views
