#include <glassbox/base/elementary.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace glassbox {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// ln 2 as a sum of two doubles. The first has 32 bits, so that its product with an exponent (11
// bits) is exact.
constexpr double kLn2High = 0x1.62e42feep-1;
constexpr double kLn2Low = 0x1.a39ef35793c76p-33;

// ln(1 + f) = 2 artanh(s) with s = f / (2 + f), and 2 artanh(s) = 2 s (1 + s^2/3 + s^4/5 + ...).
// This returns the series in brackets without its first term 1, doubled: s^2 (2/3 + s^2 2/5 + ...).
// With |s| <= 0.1716, the terms left out are below 2^-60 of ln(1 + f).
double artanh_rest(double s) {
  const double z = s * s;
  constexpr double c3 = 2.0 / 3, c5 = 2.0 / 5, c7 = 2.0 / 7, c9 = 2.0 / 9, c11 = 2.0 / 11,
                   c13 = 2.0 / 13, c15 = 2.0 / 15, c17 = 2.0 / 17, c19 = 2.0 / 19, c21 = 2.0 / 21,
                   c23 = 2.0 / 23;
  const double high = c13 + z * (c15 + z * (c17 + z * (c19 + z * (c21 + z * c23))));
  return z * (c3 + z * (c5 + z * (c7 + z * (c9 + z * (c11 + z * high)))));
}

// (e^r - 1 - r) / r^2 by Taylor's series. For |r| <= 0.3466, the terms left out are below 2^-60.
double exponential_rest(double r) {
  constexpr double c2 = 1.0 / 2, c3 = 1.0 / 6, c4 = 1.0 / 24, c5 = 1.0 / 120, c6 = 1.0 / 720,
                   c7 = 1.0 / 5040, c8 = 1.0 / 40320, c9 = 1.0 / 362880, c10 = 1.0 / 3628800,
                   c11 = 1.0 / 39916800, c12 = 1.0 / 479001600, c13 = 1.0 / 6227020800,
                   c14 = 1.0 / 87178291200;
  const double high = c9 + r * (c10 + r * (c11 + r * (c12 + r * (c13 + r * c14))));
  return c2 + r * (c3 + r * (c4 + r * (c5 + r * (c6 + r * (c7 + r * (c8 + r * high))))));
}

// sqrt(x^2 + y^2 + z^2). Where the squares would overflow or underflow, all three numbers are first
// divided by the power of two of the largest one, which is exact.
double root_of_squares(double x, double y, double z) {
  if (std::isinf(x) || std::isinf(y) || std::isinf(z)) return kInfinity;
  const double largest = std::max({std::abs(x), std::abs(y), std::abs(z)});
  if (std::isnan(x + y + z)) return kNan;
  // In this range no square that matters is subnormal or infinite, so scaling would change no bit.
  if (largest > 0x1p-400 && largest < 0x1p500) return std::sqrt(x * x + y * y + z * z);
  if (largest == 0) return 0;
  const int scale = std::ilogb(largest);
  x = std::ldexp(x, -scale);
  y = std::ldexp(y, -scale);
  z = std::ldexp(z, -scale);
  return std::ldexp(std::sqrt(x * x + y * y + z * z), scale);
}

}  // namespace

double logarithm(double x) {
  if (x == 0) return -kInfinity;
  if (!(x > 0)) return kNan;
  if (x == kInfinity) return x;
  int exponent = 0;
  double fraction = std::frexp(x, &exponent);  // 1/2 <= fraction < 1
  if (fraction < 0.70710678118654752440) {
    fraction *= 2;
    --exponent;
  }
  const double f = fraction - 1;  // exact, because the fraction is within a factor of two of 1
  const double half_square = 0.5 * f * f;
  const double s = f / (2 + f);
  // ln(1 + f) = f - (half_square - s (half_square + rest)), where rest = artanh_rest(s). The term
  // subtracted from f is small, so that the rounding errors in it have little effect.
  const double correction = s * (half_square + artanh_rest(s));
  const double k = exponent;
  return k * kLn2High - ((half_square - (correction + k * kLn2Low)) - f);
}

// u is 1 + x after rounding, and u - 1 is computed exactly. ln(u) is multiplied by x / (u - 1),
// because the ratio ln(1 + y) / y hardly differs between y = x and y = u - 1.
double logarithm_1p(double x) {
  const double u = 1 + x;
  if (u == 1 || !std::isfinite(u) || !(u > 0)) return u == 1 ? x : logarithm(u);
  return logarithm(u) * (x / (u - 1));
}

double exponential(double x) {
  if (std::isnan(x)) return x;
  if (x > 709.79) return kInfinity;
  if (x < -745.14) return 0;
  const double k = std::floor(x * 1.4426950408889634074 + 0.5);
  // x - k ln 2 = r + lost with |r| <= ln 2 / 2. The first subtraction is exact, and `lost` is what
  // the second one rounds away.
  const double high = x - k * kLn2High, low = k * kLn2Low;
  const double r = high - low;
  const double lost = (high - r) - low;
  return std::ldexp(1 + (r + (r * r * exponential_rest(r) + lost)), int(k));
}

double power(double x, double y) {
  if (x == 0 && y > 0) return 0;
  if (!(x > 0)) return kNan;
  return exponential(y * logarithm(x));
}

double whole_power(double x, int n) {
  if (n == 0) return 1;
  double product = x;
  for (int i = 1; i < n; ++i) product *= x;
  return product;
}

double power_of_ten(int n) {
  return n < 0 ? 1 / whole_power(10, -n) : whole_power(10, n);
}

double logarithm_2(double x) {
  int exponent = 0;
  if (x > 0 && x < kInfinity && std::frexp(x, &exponent) == 0.5) return exponent - 1;
  return logarithm(x) * 1.4426950408889634074;
}

double logarithm_10(double x) {
  const double found = logarithm(x) * 0.43429448190325182765;
  const double whole = std::floor(found + 0.5);
  if (!(std::abs(whole) <= 22)) return found;
  return x == power_of_ten(int(whole)) ? whole : found;
}

// Kahan's first guess is a third of the number's bits, read as a number, which is within 5 % of the
// root. Halley's iteration cubes the relative error and multiplies it by 2/3: 8e-5, 4e-13, then
// less than rounding. The last correction, which is subtracted from a nearly exact root, is small,
// so that its own rounding errors have little effect.
double cube_root(double x) {
  if (x == 0 || !std::isfinite(x)) return x;
  const double size = std::abs(x);
  // Subnormal numbers have a different layout of bits, and the largest numbers would overflow
  // below, so the number is multiplied or divided by 2^54. The cube root of this factor is 2^18, so
  // both steps are exact.
  if (size < 0x1p-1022) return cube_root(x * 0x1p54) * 0x1p-18;
  if (size > 0x1p1020) return cube_root(x * 0x1p-54) * 0x1p18;
  constexpr std::uint64_t kTwoThirdsOfOne = 0x2a9f7893ull << 32;
  double root = std::bit_cast<double>(std::bit_cast<std::uint64_t>(size) / 3 + kTwoThirdsOfOne);
  for (int step = 0; step < 3; ++step) {
    const double cube = root * root * root;
    root -= root * ((cube - size) / (2 * cube + size));
  }
  return std::copysign(root, x);
}

double hypotenuse(double x, double y) {
  return root_of_squares(x, y, 0);
}

double hypotenuse(double x, double y, double z) {
  return root_of_squares(x, y, z);
}

}  // namespace glassbox
