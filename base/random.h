// Pseudorandom numbers for studies, labs and tests: the same seed gives the same numbers on every
// machine.
#pragma once

#include <cmath>
#include <cstdint>

namespace glassbox {

// The generator SplitMix64 (Steele, Lea and Flood 2014).
class Random {
public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  // Uniform in [0, 1), a multiple of 2^-53.
  double unit() { return double(bits() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  // between(low, high) times 2^n, where every whole number n in [lowest, highest] is equally
  // likely: numbers of many sizes.
  double scaled(double low, double high, int lowest, int highest) {
    const double significand = between(low, high);
    return std::ldexp(significand, int(integer(lowest, highest)));
  }
  // Uniform in [low, high], both included.
  std::int64_t integer(std::int64_t low, std::int64_t high) {
    return low + std::int64_t(bits() % std::uint64_t(high - low + 1));
  }

private:
  std::uint64_t state_;
};

}  // namespace glassbox
