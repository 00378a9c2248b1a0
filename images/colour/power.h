// Cube roots and powers of floats without the C library: the same bits on every machine, in loops
// that the compiler can vectorise.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

namespace glassbox {

// The cube root of a float in [2^-80, 2^100], relative error below 2^-23. The first guess divides
// the bits, as a number, by three (Kahan) and is within 3.3 % of the root. Halley's iteration cubes
// the relative error and multiplies it by 2/3: 2.4e-5, then 1e-14, so only the rounding of the last
// step remains.
inline float cube_root(float value) {
  const float bits = float(std::bit_cast<std::int32_t>(value));
  float root = std::bit_cast<float>(std::int32_t(bits * (1.0f / 3.0f)) + 709958130);
  for (int step = 0; step < 2; ++step) {
    const float cube = root * root * root;
    root -= root * (cube - value) / (2.0f * cube + value);
  }
  return root;
}

// log2 of a normal positive float, absolute error below 2^-23 max(1, |log2|).
inline float log_2(float value) {
  // value = 2^exponent * mantissa with mantissa in [sqrt(1/2), sqrt(2)).
  constexpr std::int32_t kRootHalf = 0x3f3504f3;
  const std::int32_t shifted = std::bit_cast<std::int32_t>(value) - kRootHalf;
  const std::int32_t exponent = shifted >> 23;
  const float mantissa = std::bit_cast<float>((shifted & 0x7fffff) + kRootHalf);
  // ln m = 2 artanh s with m the mantissa, s = (m - 1)/(m + 1) and |s| < 0.172, as a series in s;
  // the first omitted term is below 2/11 s^11 = 7e-10.
  const float s = (mantissa - 1.0f) / (mantissa + 1.0f);
  const float z = s * s;
  const float series = ((z * (1.0f / 9.0f) + 1.0f / 7.0f) * z + 1.0f / 5.0f) * z + 1.0f / 3.0f;
  constexpr float kTwoOverLn2 = 2.8853900817779268f;
  return float(exponent) + kTwoOverLn2 * (s + s * z * series);
}

// 2^value for value in [-126, 127], relative error below 2^-22.
inline float exp_2(float value) {
  constexpr float kRound = 0x1.8p23f;  // adding it leaves the nearest integer in the low bits
  const float shifted = value + kRound;
  const float rest = (value - (shifted - kRound)) * 0.69314718055994531f;  // in [-0.347, 0.347]
  // The series of exp(rest); the first omitted term is below rest^8/8! = 5.2e-9.
  float series = 1.0f / 5040.0f * rest + 1.0f / 720.0f;
  series = series * rest + 1.0f / 120.0f;
  series = series * rest + 1.0f / 24.0f;
  series = series * rest + 1.0f / 6.0f;
  series = series * rest + 0.5f;
  series = series * rest + 1.0f;
  const std::int32_t exponent = std::bit_cast<std::int32_t>(shifted) << 23;
  return std::bit_cast<float>(std::bit_cast<std::int32_t>(series * rest + 1.0f) + exponent);
}

// base^exponent for base >= 0 and exponent >= 0 where the result is at most 2^127; 0^0 is 1.
// Relative error below 2^-21 + 2^-23 |log2 of the result|. Bases below 2^-126 count as 0.
inline float power(float base, float exponent) {
  const float log = log_2(std::max(base, 0x1p-126f)) * exponent;
  const float result = exp_2(std::max(log, -126.0f));
  const float below = exponent > 0.0f ? 0.0f : result;
  return base < 0x1p-126f ? below : result;
}

}  // namespace glassbox
