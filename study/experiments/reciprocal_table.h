// Approximate reciprocals as processors have them, the same bits everywhere.
//
// The instructions themselves (rcpps, rsqrtps, frecpe) are specified by a bound only, 1.5 * 2^-12 on x86, and differ
// between makers. These look their answers up in tables as small as the instructions' own, so that errors can be
// repeated to the last digit; what is timed is the instruction.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace glassbox::study {

// 13 fraction bits, halves rounded up, of a number in [1/2, 1].
inline double to_13_bits(double x) {
  return std::floor(x * 0x1p13 + 0.5) * 0x1p-13;
}

// For normal w > 0 with a normal reciprocal. The mantissa's first 11 bits choose an interval whose middle is taken: off by
// 2^-12 at most; the answer is rounded to 13 bits, off by 2^-14 of numbers from 1/2 on, 2^-13 in relation. The two are
// largest at opposite ends of the mantissa: 2^-12 + 2^-14 at most.
inline constexpr double kReciprocalError = 0x1p-12 + 0x1p-14;
inline float approximate_reciprocal(float w) {
  int exponent = 0;
  const double mantissa = 2 * std::frexp(double(w), &exponent);  // [1, 2)
  const double middle = std::floor(mantissa * 0x1p11) * 0x1p-11 + 0x1p-12;
  return float(std::ldexp(to_13_bits(1 / middle), 1 - exponent));
}

// A table for 1/sqrt(w): an even exponent is taken out, 10 bits choose an interval of [1, 2) or [2, 4), and half of its
// relative width is passed on: 2^-12 at a mantissa of 1, and the rounding there is largest for 1/sqrt(2), 2^-14 sqrt(2).
inline constexpr double kReciprocalRootError = 0x1p-12 + 0x1.6a09e7p-14;
inline float approximate_reciprocal_root(float w) {
  int exponent = 0;
  double mantissa = 2 * std::frexp(double(w), &exponent);
  exponent -= 1;
  const double middle = std::floor(mantissa * 0x1p10) * 0x1p-10 + 0x1p-11;
  const bool odd = exponent % 2 != 0;
  const double even = odd ? middle * 2 : middle;  // [1, 4)
  return float(std::ldexp(to_13_bits(1 / std::sqrt(even)), -(odd ? exponent - 1 : exponent) / 2));
}

// One step of Newton's method: x (2 - w x), whose error is the square of x's.
inline float newton_reciprocal(float w, float x) {
  return x * (2.0f - w * x);
}
// y (3/2 - w/2 y y): 3/2 of the square.
inline float newton_reciprocal_root(float w, float y) {
  return y * (1.5f - (0.5f * w) * y * y);
}

// Half the bits of a float are half its logarithm, nearly (0x5f3759df; Lomont 2003).
inline float magic_reciprocal_root(float w) {
  return std::bit_cast<float>(0x5f3759dfu - (std::bit_cast<std::uint32_t>(w) >> 1));
}

}  // namespace glassbox::study
