// The quantities in which error bounds are written: the unit roundoff u, gamma(k), and distances in
// ulps (units in the last place).
//
// Every operation multiplies its exact result by a factor 1 + d with |d| <= u; k operations in a
// row multiply it by at most 1 + gamma(k) (Higham, Accuracy and Stability of Numerical Algorithms,
// 2nd ed., section 3.1).
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace glassbox {

// The unit roundoff u: 2^-24 for float, 2^-53 for double.
template <class T>
inline constexpr T unit_roundoff = std::numeric_limits<T>::epsilon() / 2;

// gamma(k) = k u / (1 - k u). It is a double for both types, so that a bound does not itself lose
// digits.
template <class T>
constexpr double gamma(int k) {
  const double ku = double(k) * double(unit_roundoff<T>);
  return ku / (1 - ku);
}

// The gap between |x| and the next larger number of its format, which is the unit in its last
// place; the smallest subnormal at 0. Infinity and NaN give NaN.
template <class T>
T ulp(T x) {
  const T a = std::abs(x);
  if (!(a <= std::numeric_limits<T>::max())) return std::numeric_limits<T>::quiet_NaN();
  using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  const Bits bits = std::bit_cast<Bits>(a);
  if (a == std::numeric_limits<T>::max()) return a - std::bit_cast<T>(Bits(bits - 1));
  return std::bit_cast<T>(Bits(bits + 1)) - a;
}

// The number of steps between neighbouring numbers of the format that lead from a to b: 0 for equal
// numbers (-0 and 0 are equal), 1 for neighbours. A NaN has the largest distance that the result
// can express from every number.
template <class T>
std::uint64_t ulp_distance(T a, T b) {
  if (std::isnan(a) || std::isnan(b)) return std::numeric_limits<std::uint64_t>::max();
  using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  // The bits of magnitudes, read as integers, count up from 0, so the distance is a difference; for
  // numbers of opposite signs it is the sum of the distances from 0.
  const std::uint64_t ma = std::bit_cast<Bits>(std::abs(a)), mb = std::bit_cast<Bits>(std::abs(b));
  if (std::signbit(a) != std::signbit(b)) return ma + mb;
  return ma > mb ? ma - mb : mb - ma;
}

// |value - exact| in ulps of the exact value. `exact` is a reference of higher precision that can
// be converted to double.
template <class Exact>
double error_in_ulps(double value, const Exact& exact) {
  return std::abs(double((Exact(value) - exact) / Exact(ulp(double(exact)))));
}

}  // namespace glassbox
