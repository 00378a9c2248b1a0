#include <glassbox/base/trig.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>

namespace glassbox {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPiLow = 0x1.1a62633145c07p-53;       // pi - kPi
constexpr double kSqrtHalf = 0.707106781186547524401;  // sin and cos of 45 degrees

// A number stored as the sum high + low: `low` is the part for which `high` has no bits.
struct Pair {
  double high = 0, low = 0;
};

// An angle reduced by multiples of a quarter turn, with |remainder| at most about pi/4.
struct Reduced {
  Pair remainder;  // radians
  int quadrant = 0;
};

// x with its 27 lowest bits cleared. 26 bits are left, so that a product with a factor of 27 bits
// is exact.
double upper_half(double x) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & ~std::uint64_t(0x7ffffff));
}

// ---- series ----
// The coefficients are Taylor's, each the correctly rounded quotient. For |r| <= pi/4, the terms
// left out are below 0.001 ulp of the sine and 0.0001 ulp of the cosine.

// sin(high + low) = high + (high^3 (-1/3! + high^2/5! ...) + low cos(high)). The term added to
// `high` is much smaller than `high`, so that its rounding errors have little effect.
double sin_series(Pair r) {
  const double x = r.high, z = x * x;
  constexpr double c3 = -1.0 / 6, c5 = 1.0 / 120, c7 = -1.0 / 5040, c9 = 1.0 / 362880,
                   c11 = -1.0 / 39916800, c13 = 1.0 / 6227020800, c15 = -1.0 / 1307674368000,
                   c17 = 1.0 / 355687428096000;
  const double p =
      c3 + z * (c5 + z * (c7 + z * (c9 + z * (c11 + z * (c13 + z * (c15 + z * c17))))));
  return x + (x * (z * p) + r.low * (1 - 0.5 * z));
}

// cos(high + low) = (1 - h) + (lost + high^4 (1/4! - ...) - high low) with h = high^2/2, where
// `lost` is the rounding error of 1 - h.
double cos_series(Pair r) {
  const double x = r.high, z = x * x;
  constexpr double c4 = 1.0 / 24, c6 = -1.0 / 720, c8 = 1.0 / 40320, c10 = -1.0 / 3628800,
                   c12 = 1.0 / 479001600, c14 = -1.0 / 87178291200, c16 = 1.0 / 20922789888000,
                   c18 = -1.0 / 6402373705728000;
  const double q =
      c4 + z * (c6 + z * (c8 + z * (c10 + z * (c12 + z * (c14 + z * (c16 + z * c18))))));
  const double h = 0.5 * z;
  const double head = 1 - h;
  const double lost = (1 - head) - h;  // exact: head is within a factor of two of 1
  return head + (lost + (z * z * q - x * r.low));
}

SinCos turn(const Reduced& r) {
  const double s = sin_series(r.remainder), c = cos_series(r.remainder);
  switch (r.quadrant) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

// ---- reductions ----

int quadrant_of(double turns) {
  return int(std::int64_t(turns) & 3);
}

// The method of Cody and Waite (1980): pi/2 is a sum of parts of 33 bits, so that their products
// with up to 20 bits of n are exact. What these parts lack of pi/2 is below 2^-157 n, and no double
// up to 2^20 is nearer than about 2^-60 to a multiple of pi/2, so the remainder has more than 70
// correct bits.
Reduced reduce_radians(double x) {
  constexpr double p1 = 0x1.921fb544p+0, p2 = 0x1.0b4611a6p-34, p3 = 0x1.3198a2ep-69,
                   p4 = 0x1.b839a252049c1p-104;
  const double n = std::floor(x * 0.63661977236758134308 + 0.5);
  // Exact: x and n p1 are multiples of x's last bit or of a coarser one, and their difference is
  // small.
  const double a = x - n * p1;
  const double b = n * p2;
  // Knuth's two-sum: a - b = high + low exactly, whichever of a and b is larger.
  const double high = a - b;
  const double b_seen = a - high;
  const double low = (a - (high + b_seen)) + (b_seen - b);
  const double tail = low - (n * p3 + n * p4);
  const double sum = high + tail;
  return {{sum, (high - sum) + tail}, quadrant_of(n)};
}

// degrees * pi/180, with the factor as a sum of two parts of 26 bits and the rest. The angle is
// split, too, so that products of parts are exact.
Pair radians_pair(double degrees) {
  constexpr double p1 = 0x1.1df46ap-6, p2 = 0x1.294e9c8p-33, p3 = 0x1.5c1d8becdd291p-62;
  const double d1 = upper_half(degrees), d2 = degrees - d1;
  const double head = d1 * p1;
  const double tail = d2 * p1 + (d1 * p2 + (d2 * p2 + degrees * p3));
  const double sum = head + tail;
  return {sum, (head - sum) + tail};
}

// Sine and cosine for degrees >= 0.
SinCos sin_cos_degrees_positive(double degrees) {
  const double n = std::floor(degrees / 90 + 0.5);
  // Exact: 90 n is an integer below 2^27, and the difference is small.
  const double rest = degrees - 90 * n;
  const int quadrant = quadrant_of(n);
  if (rest == 45 || rest == -45) {
    const bool s_negative =
        (quadrant == 0 && rest < 0) || quadrant == 3 || (quadrant == 2 && rest > 0);
    const bool c_negative =
        quadrant == 2 || (quadrant == 1 && rest > 0) || (quadrant == 3 && rest < 0);
    return {s_negative ? -kSqrtHalf : kSqrtHalf, c_negative ? -kSqrtHalf : kSqrtHalf};
  }
  return turn({radians_pair(rest), quadrant});
}

// ---- arctangent ----

// arctan(k/16) for k = 5 .. 16 and arctan(16/k) for k = 0 .. 16, to about 107 bits.
constexpr int kFirstOfLowTable = 5;
constexpr Pair kArctanOfSixteenths[] = {
    {0x1.362773707ebccp-2, -0x1.963a544b672d8p-57},  // 5/16
    {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56}, {0x1.a64eec3cc23fdp-2, -0x1.24dec1b50b7ffp-56},
    {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},  {0x1.0657e94db30dp-1, -0x1.d5b495f6349e6p-56},
    {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58}, {0x1.345f01cce37bbp-1, 0x1.1021137c71102p-55},
    {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},  {0x1.5d58987169b18p-1, 0x1.0028e4bc5e7cap-57},
    {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56}, {0x1.819d0b7158a4dp-1, -0x1.bf76229d3b917p-56},
    {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},  // 16/16
};
constexpr Pair kArctanOfInverseSixteenths[] = {
    {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54},  // 16/0
    {0x1.82250768ac529p+0, -0x1.e78c96d05afcbp-58},
    {0x1.7249faa996a21p+0, 0x1.a8cc1e7480c68p-54},
    {0x1.62acbeaca61b8p+0, 0x1.c6ac9f134fa91p-60},
    {0x1.5368c951e9cfdp+0, -0x1.96f47948a99f1p-54},
    {0x1.4495d86823225p+0, 0x1.4d29adbab2a62p-54},
    {0x1.3647503caf55cp+0, 0x1.17e21d9a42c9ap-55},
    {0x1.288bfa3512419p+0, 0x1.8e684e7a2281bp-56},
    {0x1.1b6e192ebbe44p+0, 0x1.b1b466a88828ep-54},
    {0x1.0ef3c09d694bp+0, 0x1.8fcf88aed2e8p-54},
    {0x1.031f57e54adbep+0, 0x1.338b4259c027p-54},
    {0x1.efe068bba2275p-1, 0x1.24a3b2e61a70bp-55},
    {0x1.dac670561bb4fp-1, 0x1.a2b7f222f65e2p-55},
    {0x1.c6e6d2171bf18p-1, 0x1.f4ba8d3373e1bp-55},
    {0x1.b434ee31013fdp-1, -0x1.0520d0701d877p-55},
    {0x1.a2a25f172cfe4p-1, -0x1.d700509dad6cep-56},
    {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},  // 16/16
};

// arctan(t) - t by the first `terms` terms of Gregory's series, -t^3/3 + t^5/5 - ..., of which the
// smallest is added first.
double arctan_minus_t(double t, int terms) {
  constexpr double c[] = {-1.0 / 3, 1.0 / 5,   -1.0 / 7, 1.0 / 9,   -1.0 / 11, 1.0 / 13,  -1.0 / 15,
                          1.0 / 17, -1.0 / 19, 1.0 / 21, -1.0 / 23, 1.0 / 25,  -1.0 / 27, 1.0 / 29};
  static_assert(std::size(c) == 14);
  const double z = t * t;
  double p = c[terms - 1];
  for (int i = terms - 2; i >= 0; --i) p = c[i] + z * p;
  return t * (z * p);
}
constexpr int kTermsBelow9Over32 = 14;  // left out: (9/32)^30/31 of the result, 0.01 ulp
constexpr int kTermsBelow1Over31 = 5;   // left out: 31^-12/13 of t

// arctan(a) = arctan(c) + arctan(t) with t = (a - c)/(1 + a c), for 9/32 <= a <= 1. c is a multiple
// of 1/16 near a, whose arctangent is in a table. |t| < 1/31, so its rounding error is a small part
// of an ulp of the sum.
double arctan_by_table(double a) {
  const int k = int(std::floor(a * 16 + 0.5));
  const double c = k * 0.0625;
  const double t = (a - c) / (1 + a * c);
  const Pair& base = kArctanOfSixteenths[k - kFirstOfLowTable];
  return base.high + (base.low + (t + arctan_minus_t(t, kTermsBelow1Over31)));
}

// The same for a > 1, with 1/c in place of c: arctan(a) = arctan(1/c) + arctan((a c - 1)/(a + c)).
// c is 0 for a > 32.
double arctan_of_large(double a) {
  const int k = int(std::floor(16 / a + 0.5));
  const double c = k * 0.0625;
  // a c is nearly 1, or 0. If a is split into a1 + a2, the products with c are exact, and so is a1
  // c - 1.
  const double a1 = upper_half(a), a2 = a - a1;
  const double t = k == 0 ? -1 / a : ((a1 * c - 1) + a2 * c) / (a + c);
  const Pair& base = kArctanOfInverseSixteenths[k];
  return base.high + (base.low + (t + arctan_minus_t(t, kTermsBelow1Over31)));
}

// The arctangent for a >= 0.
double arctan_positive(double a) {
  if (a < 0.28125) return a + arctan_minus_t(a, kTermsBelow9Over32);
  return a <= 1 ? arctan_by_table(a) : arctan_of_large(a);
}

}  // namespace

SinCos sin_cos(double radians) {
  const double x = std::abs(radians);
  if (!(x <= kMaxRadians)) return {kNan, kNan};
  const SinCos r = turn(reduce_radians(x));
  return {std::signbit(radians) ? -r.sin : r.sin, r.cos};
}

SinCos sin_cos_degrees(double degrees) {
  const double x = std::abs(degrees);
  if (!(x <= kMaxDegrees)) return {kNan, kNan};
  const SinCos r = sin_cos_degrees_positive(x);
  // + 0.0 turns -0 into 0 and leaves every other number unchanged.
  return {(std::signbit(degrees) ? -r.sin : r.sin) + 0.0, r.cos + 0.0};
}

// The double kHalfPi is not exactly a right angle: the sine and cosine of its half round to
// different doubles, although their exact quotient, 1 + 6e-17, rounds to 1.
double cot_half(double radians) {
  if (radians == kHalfPi) return 1;
  const SinCos half = sin_cos(radians * 0.5);
  return half.cos / half.sin;
}

double tan_half(double radians) {
  if (radians == kHalfPi) return 1;
  const SinCos half = sin_cos(radians * 0.5);
  return half.sin / half.cos;
}

double cot_half_degrees(double degrees) {
  const SinCos half = sin_cos_degrees(degrees * 0.5);
  return half.cos / half.sin;
}

double tan_half_degrees(double degrees) {
  const SinCos half = sin_cos_degrees(degrees * 0.5);
  return half.sin / half.cos;
}

double arctan(double x) {
  if (std::isnan(x)) return kNan;
  return std::copysign(arctan_positive(std::abs(x)), x);
}

double arctan2(double y, double x) {
  if (std::isnan(y) || std::isnan(x)) return kNan;
  const double ay = std::abs(y), ax = std::abs(x);
  double angle = 0;
  if (ay == kInfinity && ax == kInfinity) {
    angle = std::signbit(x) ? 3 * (kHalfPi * 0.5) : kHalfPi * 0.5;
  } else if (ax == 0 && ay != 0) {
    angle = kHalfPi;  // avoids a division by zero
  } else if (!std::signbit(x)) {
    angle = ay == 0 ? 0 : arctan_positive(ay / ax);
  } else if (ay > ax) {
    angle = kHalfPi + (arctan_positive(ax / ay) + kPiLow * 0.5);
  } else {
    angle = kPi - ((ay == 0 ? 0 : arctan_positive(ay / ax)) - kPiLow);
  }
  return std::copysign(angle, y);
}

}  // namespace glassbox
