// A mean that does not depend on the order in which values are added: the values are rounded to
// multiples of 2^-32 and summed as whole numbers.
#pragma once

#include <cstdint>

namespace glassbox {

// Each value in [-1, 1] is rounded to a multiple of 2^-32, which changes the mean by at most 2^-33
// (1.2e-10). Sums of whole numbers are exact, so threads may add their values in any order. The sum
// has room for 2^30 values.
class FixedSum {
public:
  // Adds the value `times` times. Adding and subtracting 3 * 2^51 rounds a double of this size to
  // the nearest integer.
  void add(double value, std::uint64_t times = 1) {
    constexpr double kRound = 0x1.8p52;
    sum_ += std::int64_t(value * 0x1p32 + kRound - kRound) * std::int64_t(times);
    count_ += times;
  }
  void add(const FixedSum& other) {
    sum_ += other.sum_;
    count_ += other.count_;
  }
  std::uint64_t count() const { return count_; }
  double mean() const { return double(sum_) * 0x1p-32 / double(count_); }  // where count() > 0

private:
  std::int64_t sum_ = 0;
  std::uint64_t count_ = 0;
};

}  // namespace glassbox
