// Compares the trigonometric functions with 50-digit arithmetic (Boost.Multiprecision). Errors are
// in ulps of the exact result.
#include <glassbox/base/random.h>
#include <tests/support/catch.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include <glassbox/base/rounding.h>
#include <glassbox/base/trig.h>

namespace glassbox {
namespace {

// Reducing an argument of up to 2^20 costs 7 of the 50 digits; 16 are needed.
using Exact = boost::multiprecision::cpp_bin_float_50;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const Exact kExactPi = boost::multiprecision::acos(Exact(-1));

struct WorstError {
  double ulps = 0;
  double argument = 0;
  void add(double x, double value, const Exact& exact) {
    if (exact == 0) {
      if (value != 0) *this = {kInfinity, x};
      return;
    }
    const double error = error_in_ulps(value, exact);
    if (!(error <= ulps)) *this = {error, x};  // a NaN counts as the worst error
  }
};

// Returns `count` random angles up to `largest`, half of them below a full turn, and angles at and
// near the multiples of a quarter turn.
std::vector<double> angles(int count, double largest, double quarter_turn) {
  Random random(20);
  std::vector<double> list;
  for (int i = 0; i < count; ++i) {
    const double limit = i % 2 == 0 ? largest : 4 * quarter_turn;
    list.push_back(random.between(-limit, limit));
  }
  for (int e = -60; e <= 0; ++e) list.push_back(std::ldexp(1.0 + random.unit(), e));
  for (int n = 0; n <= 2000; ++n) {
    const double at = n <= 1000 ? quarter_turn * n
                                : quarter_turn * std::floor(random.unit() * largest / quarter_turn);
    list.push_back(at);
    list.push_back(std::nextafter(at, kInfinity));
    list.push_back(std::nextafter(at, -kInfinity));
    list.push_back(at + quarter_turn / 2);
  }
  std::erase_if(list, [=](double x) { return std::abs(x) > largest; });
  return list;
}

TEST_CASE("sine and cosine err by less than an ulp up to 2^20 radians") {
  WorstError sin, cos;
  for (double x : angles(30000, kMaxRadians, kHalfPi)) {
    const SinCos value = sin_cos(x);
    sin.add(x, value.sin, boost::multiprecision::sin(Exact(x)));
    cos.add(x, value.cos, boost::multiprecision::cos(Exact(x)));
  }
  INFO("worst sine " << sin.ulps << " ulps at " << sin.argument << ", cosine " << cos.ulps << " at "
                     << cos.argument);
  CHECK(sin.ulps < 0.80);
  CHECK(cos.ulps < 0.85);
}

TEST_CASE("sine and cosine of degrees err by less than an ulp up to 2^26 degrees") {
  WorstError sin, cos;
  for (double x : angles(30000, kMaxDegrees, 90)) {
    const SinCos value = sin_cos_degrees(x);
    // The angle is reduced in degrees, which is exact, before the reference multiplies it by pi /
    // 180, which is rounded too.
    const Exact radians = Exact(std::remainder(x, 360.0)) * kExactPi / 180;
    Exact s = boost::multiprecision::sin(radians), c = boost::multiprecision::cos(radians);
    if (std::fmod(x, 180) == 0) s = 0;
    if (std::abs(std::fmod(x, 180)) == 90) c = 0;
    sin.add(x, value.sin, s);
    cos.add(x, value.cos, c);
  }
  INFO("worst sine " << sin.ulps << " ulps at " << sin.argument << ", cosine " << cos.ulps << " at "
                     << cos.argument);
  CHECK(sin.ulps < 0.80);
  CHECK(cos.ulps < 0.85);
}

TEST_CASE("the arctangent errs by less than an ulp") {
  Random random(21);
  std::vector<double> list;
  for (int i = 0; i < 20000; ++i) list.push_back(random.between(-2, 2));
  for (int i = 0; i < 10000; ++i) list.push_back(random.scaled(1, 2, -40, 60));
  for (int k = 0; k <= 33; ++k) {  // edges of the table's intervals
    const double edge = k / 32.0;
    for (double x : {edge, 1 / edge}) {
      list.push_back(x);
      list.push_back(std::nextafter(x, 0));
      list.push_back(std::nextafter(x, kInfinity));
    }
  }
  std::erase_if(list, [](double x) { return std::isinf(x); });
  WorstError worst;
  for (double x : list) worst.add(x, arctan(x), boost::multiprecision::atan(Exact(x)));
  INFO("worst " << worst.ulps << " ulps at " << worst.argument);
  CHECK(worst.ulps < 0.85);
}

TEST_CASE("the angle of a vector errs by less than two ulps in every quadrant") {
  Random random(22);
  WorstError worst;
  for (int i = 0; i < 30000; ++i) {
    const double y = random.scaled(-1, 1, -20, 20);
    const double x = random.scaled(-1, 1, -20, 20);
    worst.add(y / x, arctan2(y, x), boost::multiprecision::atan2(Exact(y), Exact(x)));
  }
  INFO("worst " << worst.ulps << " ulps at y/x = " << worst.argument);
  CHECK(worst.ulps < 1.6);
}

TEST_CASE(
    "the half-angle cotangent and tangent err by less than 2.5 ulps, also next to 0 and 180 "
    "degrees (C-08)") {
  Random random(23);
  WorstError cot, tan, cot_degrees, tan_degrees;
  std::vector<double> degrees{1e-6, 1e-9, 1e-100, 90, 179.9999, 179.9999999999, 60, 45, 120};
  for (int i = 0; i < 20000; ++i) degrees.push_back(random.between(0, 180));
  for (double d : degrees) {
    const double r = radians_from_degrees(d);
    const Exact exact = boost::multiprecision::tan(Exact(r) / 2);
    const Exact exact_degrees = boost::multiprecision::tan(Exact(d) * kExactPi / 360);
    tan.add(r, tan_half(r), exact);
    cot.add(r, cot_half(r), 1 / exact);
    tan_degrees.add(d, tan_half_degrees(d), exact_degrees);
    cot_degrees.add(d, cot_half_degrees(d), 1 / exact_degrees);
  }
  INFO("cot " << cot.ulps << " tan " << tan.ulps << " cot degrees " << cot_degrees.ulps
              << " tan degrees " << tan_degrees.ulps);
  CHECK(std::max({cot.ulps, tan.ulps, cot_degrees.ulps, tan_degrees.ulps}) < 2.1);
}

TEST_CASE("multiples of 90 degrees are exact and never -0") {
  for (int turns = -40; turns <= 40; ++turns) {
    const double expected[4][2] = {{0, 1}, {1, 0}, {0, -1}, {-1, 0}};  // sine, cosine
    const SinCos value = sin_cos_degrees(90.0 * turns);
    CAPTURE(turns);
    CHECK(value.sin == expected[turns & 3][0]);
    CHECK(value.cos == expected[turns & 3][1]);
    CHECK(!(value.sin == 0 && std::signbit(value.sin)));
    CHECK(!(value.cos == 0 && std::signbit(value.cos)));
  }
}

TEST_CASE("odd multiples of 45 degrees have sine and cosine of the same size and the right signs") {
  for (int k = -81; k <= 81; k += 2) {
    const SinCos value = sin_cos_degrees(45.0 * k);
    CAPTURE(k);
    CHECK(std::abs(value.sin) == std::sqrt(0.5));
    CHECK(std::abs(value.cos) == std::sqrt(0.5));
    const int eighth = k & 7;
    CHECK(std::signbit(value.sin) == (eighth > 4));
    CHECK(std::signbit(value.cos) == (eighth == 3 || eighth == 5));
  }
}

TEST_CASE("sine is odd and cosine is even, exactly") {
  Random random(24);
  for (int i = 0; i < 2000; ++i) {
    const double x = random.between(0, 1000);
    CHECK(sin_cos(-x).sin == -sin_cos(x).sin);
    CHECK(sin_cos(-x).cos == sin_cos(x).cos);
    CHECK(sin_cos_degrees(-x).sin == -sin_cos_degrees(x).sin);
    CHECK(sin_cos_degrees(-x).cos == sin_cos_degrees(x).cos);
    CHECK(arctan(-x) == -arctan(x));
  }
}

TEST_CASE("angles beyond the stated range, infinities and NaN give NaN") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (double x : {nan, kInfinity, -kInfinity, std::nextafter(kMaxRadians, kInfinity)}) {
    CHECK(std::isnan(sin_cos(x).sin));
    CHECK(std::isnan(sin_cos(x).cos));
  }
  for (double x : {nan, kInfinity, -kInfinity, std::nextafter(kMaxDegrees, kInfinity)}) {
    CHECK(std::isnan(sin_cos_degrees(x).sin));
    CHECK(std::isnan(sin_cos_degrees(x).cos));
  }
  CHECK(std::isnan(arctan(nan)));
  CHECK(std::isnan(arctan2(nan, 1)));
  CHECK(std::isnan(arctan2(1, nan)));
}

TEST_CASE("a right angle of view has a cotangent and a tangent of exactly 1, in both units") {
  CHECK(radians_from_degrees(90) == kHalfPi);
  CHECK(cot_half(kHalfPi) == 1);
  CHECK(tan_half(kHalfPi) == 1);
  CHECK(cot_half_degrees(90) == 1);
  CHECK(tan_half_degrees(90) == 1);
}

TEST_CASE("arctan2 has the quadrants, zeros and infinities of IEEE 754") {
  CHECK(arctan2(0, 1) == 0);
  CHECK(std::signbit(arctan2(-0.0, 1)));
  CHECK(arctan2(0, -1) == kPi);
  CHECK(arctan2(-0.0, -1) == -kPi);
  CHECK(arctan2(0, 0) == 0);
  CHECK(arctan2(0, -0.0) == kPi);
  CHECK(arctan2(1, 0) == kHalfPi);
  CHECK(arctan2(-1, 0) == -kHalfPi);
  CHECK(arctan2(1, -0.0) == kHalfPi);
  CHECK(arctan2(1, 1) == kHalfPi / 2);
  CHECK(arctan2(kInfinity, kInfinity) == kHalfPi / 2);
  CHECK(arctan2(kInfinity, -kInfinity) == 3 * (kHalfPi / 2));
  CHECK(arctan2(kInfinity, 5) == kHalfPi);
  CHECK(arctan2(5, kInfinity) == 0);
  CHECK(arctan2(5, -kInfinity) == kPi);
  CHECK(arctan(kInfinity) == kHalfPi);
  CHECK(std::signbit(arctan(-0.0)));
}

}  // namespace
}  // namespace glassbox
