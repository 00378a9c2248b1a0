// The vocabulary of error bounds: unit roundoffs, gamma(k), and distances in ulps.
//
// Every operation rounds its exact result by a factor 1 + d, |d| <= u; k of them in a row by at most 1 + gamma(k)
// (Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., section 3.1; SPEC 0.2).
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace glassbox {

// u: 2^-24 for float, 2^-53 for double.
template <class T>
inline constexpr T unit_roundoff = std::numeric_limits<T>::epsilon() / 2;

// k u / (1 - k u). In double for both, since bounds should not round away.
template <class T>
constexpr double gamma(int k) {
  const double ku = double(k) * double(unit_roundoff<T>);
  return ku / (1 - ku);
}

// The gap between |x| and the next larger number of its format, that is the unit in its last place; the smallest
// subnormal at 0. Infinity and NaN give NaN.
template <class T>
T ulp(T x) {
  const T a = std::abs(x);
  if (!(a <= std::numeric_limits<T>::max())) return std::numeric_limits<T>::quiet_NaN();
  using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  const Bits bits = std::bit_cast<Bits>(a);
  if (a == std::numeric_limits<T>::max()) return a - std::bit_cast<T>(Bits(bits - 1));
  return std::bit_cast<T>(Bits(bits + 1)) - a;
}

// How many numbers of the format lie between a and b: 0 for equal numbers (-0 and 0 are equal), 1 for neighbours. NaN
// is as far from everything as can be.
template <class T>
std::uint64_t ulp_distance(T a, T b) {
  if (std::isnan(a) || std::isnan(b)) return std::numeric_limits<std::uint64_t>::max();
  using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  // Magnitudes count up from 0, negative numbers from 0 downwards.
  const std::uint64_t ma = std::bit_cast<Bits>(std::abs(a)), mb = std::bit_cast<Bits>(std::abs(b));
  if (std::signbit(a) != std::signbit(b)) return ma + mb;
  return ma > mb ? ma - mb : mb - ma;
}

// |value - exact| in ulps of the exact value, for a reference of higher precision that converts to double.
template <class Exact>
double error_in_ulps(double value, const Exact& exact) {
  return std::abs(double((Exact(value) - exact) / Exact(ulp(double(exact)))));
}

}  // namespace glassbox
