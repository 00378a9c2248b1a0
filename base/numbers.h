// The operations that the formulas of the stages use (base/formulas, pipeline/formulas,
// raster/formulas), for single numbers. The formula files have no namespace of their own: they are
// included once here as functions of single numbers, and once more in raster/lanes for each
// instruction set. raster/lanes/numbers-inl.h defines the same names for as many numbers as a
// vector register holds; the text of a formula is the same in each case.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>

namespace glassbox {

template <class F>
concept Number = std::floating_point<F>;
template <class I>
concept WholeNumber = std::same_as<I, std::int32_t> || std::same_as<I, std::int64_t>;

using std::abs;
using std::floor;
using std::sqrt;

// ---- conditions ----

// Use select() for a condition that may hold for some numbers of a vector and not for others; `if`
// is only for conditions that hold for all or none.
template <class T>
inline T select(bool condition, T yes, T no) {
  return condition ? yes : no;
}
inline bool none(bool condition) {
  return !condition;
}
inline std::int32_t one_where(bool condition) {
  return condition ? 1 : 0;
}

// ---- kinds of numbers ----

// Converts to float, rounded to nearest.
inline float to_float(std::int32_t i) {
  return float(i);
}
inline float to_float(std::int64_t i) {
  return float(i);
}
// Converts a float, which must be a whole number.
inline std::int32_t to_integer(float x) {
  return std::int32_t(x);
}
inline std::int32_t to_integer(double x) {
  return std::int32_t(x);
}

inline double widened(float x) {
  return x;
}
inline float rounded(double x) {
  return float(x);
}

inline std::int32_t bits_of(float x) {
  return std::bit_cast<std::int32_t>(x);
}
inline float float_of(std::int32_t bits) {
  return std::bit_cast<float>(bits);
}

// i 2^kBits; and, below, i 2^-kBits rounded down.
template <int kBits, WholeNumber I>
inline I shifted_left(I i) {
  return i * (I(1) << kBits);
}
template <int kBits, WholeNumber I>
inline I shifted_right(I i) {
  return i >> kBits;
}
template <WholeNumber I>
inline I shifted_right(I i, I bits) {
  return i >> bits;
}

// i f 2^-15 rounded to the nearest integer, halves upwards, for |i| < 2^15 and f in [0, 2^15).
inline std::int32_t times_fraction(std::int32_t i, std::int32_t f) {
  return (i * f + (1 << 14)) >> 15;
}

#include <glassbox/base/formulas/common.h>

}  // namespace glassbox
