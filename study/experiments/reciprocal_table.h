// Approximate reciprocals as accurate as those of processors, but with the same bits on every
// machine.
//
// The instructions themselves (rcpps, rsqrtps, frecpe) are specified only by a bound, 1.5 * 2^-12
// on x86, and differ between manufacturers. These functions use tables as small as those of the
// instructions, so that errors are the same to the last digit in every run; the time is measured
// with the instruction.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace glassbox::study {

// Rounds a number in [1/2, 1] to 13 fraction bits, halves up.
inline double to_13_bits(double x) {
  return std::floor(x * 0x1p13 + 0.5) * 0x1p-13;
}

// For normal w > 0 with a normal reciprocal. The first 11 bits of the mantissa choose an interval,
// whose middle is used: a relative error of at most 2^-12. The answer is rounded to 13 bits: an
// error of 2^-14 for numbers from 1/2 on, which is at most 2^-13 relative. The two errors are
// largest at opposite ends of the mantissa, so together they are at most 2^-12 + 2^-14.
inline constexpr double kReciprocalError = 0x1p-12 + 0x1p-14;
inline float approximate_reciprocal(float w) {
  int exponent = 0;
  const double mantissa = 2 * std::frexp(double(w), &exponent);  // in [1, 2)
  const double middle = std::floor(mantissa * 0x1p11) * 0x1p-11 + 0x1p-12;
  return float(std::ldexp(to_13_bits(1 / middle), 1 - exponent));
}

// A table for 1/sqrt(w): an even exponent is taken out of w, and 10 bits choose an interval of [1,
// 2) or [2, 4). Half of the interval's relative width is the relative error of the result: 2^-12 at
// a mantissa of 1. The rounding error is largest at the same mantissa, for 1/sqrt(2): 2^-14
// sqrt(2).
inline constexpr double kReciprocalRootError = 0x1p-12 + 0x1.6a09e7p-14;
inline float approximate_reciprocal_root(float w) {
  int exponent = 0;
  double mantissa = 2 * std::frexp(double(w), &exponent);
  exponent -= 1;
  const double middle = std::floor(mantissa * 0x1p10) * 0x1p-10 + 0x1p-11;
  const bool odd = exponent % 2 != 0;
  const double even = odd ? middle * 2 : middle;  // in [1, 4)
  return float(std::ldexp(to_13_bits(1 / std::sqrt(even)), -(odd ? exponent - 1 : exponent) / 2));
}

// One step of Newton's method, x (2 - w x): the relative error is squared.
inline float newton_reciprocal(float w, float x) {
  return x * (2.0f - w * x);
}
// One step of Newton's method, y (3/2 - w/2 y y): the relative error becomes 3/2 of its square.
inline float newton_reciprocal_root(float w, float y) {
  return y * (1.5f - (0.5f * w) * y * y);
}

// A float's bits, read as an integer, are nearly its logarithm. Half of them, subtracted from a
// constant, give nearly the reciprocal root (0x5f3759df; Lomont 2003).
inline float magic_reciprocal_root(float w) {
  return std::bit_cast<float>(0x5f3759dfu - (std::bit_cast<std::uint32_t>(w) >> 1));
}

}  // namespace glassbox::study
