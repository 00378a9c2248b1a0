// Compares logarithm, exponential, powers and roots with 50-digit arithmetic
// (Boost.Multiprecision). Errors are in ulps of the exact result.
#include <glassbox/base/random.h>
#include <tests/support/catch.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <utility>
#include <vector>

#include <glassbox/base/elementary.h>
#include <glassbox/base/rounding.h>

namespace glassbox {
namespace {

using Exact = boost::multiprecision::cpp_bin_float_50;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kSmallest = std::numeric_limits<double>::denorm_min();

struct WorstError {
  double ulps = 0, argument = 0;
  void add(double x, double value, const Exact& exact) {
    const double error = exact == 0 ? (value == 0 ? 0 : kInfinity) : error_in_ulps(value, exact);
    if (!(error <= ulps)) *this = {error, x};  // a NaN counts as the worst error
  }
};

// Returns arguments of all sizes, and many near 1, where the logarithm vanishes.
std::vector<double> positive_numbers() {
  Random random(41);
  std::vector<double> list{kLargest, kSmallest, 0x1p-1022, 8, 27, 1000};
  for (int i = 0; i < 20000; ++i) list.push_back(random.scaled(1, 2, -1022, 1022));
  for (int i = 0; i < 20000; ++i) list.push_back(random.between(0.5, 2));
  for (int i = 1; i < 50; ++i) {
    list.push_back(1 + std::ldexp(1.0, -i));
    list.push_back(1 - std::ldexp(1.0, -i));
  }
  return list;
}

TEST_CASE("the natural logarithm errs by less than an ulp, the others by less than 2.5") {
  WorstError natural, two, ten;
  for (const double x : positive_numbers()) {
    natural.add(x, logarithm(x), boost::multiprecision::log(Exact(x)));
    two.add(x, logarithm_2(x), boost::multiprecision::log2(Exact(x)));
    ten.add(x, logarithm_10(x), boost::multiprecision::log10(Exact(x)));
  }
  INFO("natural " << natural.ulps << " at " << natural.argument << ", 2 " << two.ulps << " at "
                  << two.argument << ", 10 " << ten.ulps << " at " << ten.argument);
  CHECK(natural.ulps < 1);
  CHECK(two.ulps < 2.5);
  CHECK(ten.ulps < 2.5);
  for (int e = -1074; e < 1024; ++e) CHECK(logarithm_2(std::ldexp(1.0, e)) == e);
}

TEST_CASE("the logarithm of powers of ten is whole") {
  double ten = 1;
  for (int e = 0; e <= 22; ++e, ten *= 10) {
    CHECK(logarithm_10(ten) == e);
    CHECK(logarithm_10(1 / ten) == -e);
  }
}

TEST_CASE("the logarithm of 1 + x errs by less than four ulps") {
  Random random(45);
  WorstError worst;
  for (int i = 0; i < 40000; ++i) {
    const double x = i % 2 == 0 ? random.scaled(-1, 1, -60, -1) : random.between(-0.999, 1000);
    worst.add(x, logarithm_1p(x), boost::multiprecision::log1p(Exact(x)));
  }
  INFO("worst " << worst.ulps << " ulps at " << worst.argument);
  CHECK(worst.ulps < 4);
  CHECK(logarithm_1p(-1) == -kInfinity);
  CHECK(std::isnan(logarithm_1p(-2)));
  CHECK(logarithm_1p(kInfinity) == kInfinity);
}

TEST_CASE("the exponential errs by less than an ulp") {
  Random random(42);
  WorstError worst;
  for (int i = 0; i < 40000; ++i) {
    const double x = i % 2 == 0 ? random.between(-708, 709.7) : random.between(-1, 1);
    worst.add(x, exponential(x), boost::multiprecision::exp(Exact(x)));
  }
  INFO("worst " << worst.ulps << " ulps at " << worst.argument);
  CHECK(worst.ulps < 1);
}

TEST_CASE("a power errs by less than its bound") {
  Random random(43);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const double x = random.scaled(1, 2, -100, 100), y = random.between(-6, 6);
    const Exact log = Exact(y) * boost::multiprecision::log(Exact(x));
    const double bound = 1 + 3 * std::abs(double(log));
    worst = std::max(worst, error_in_ulps(power(x, y), boost::multiprecision::exp(log)) / bound);
  }
  INFO("worst " << worst << " of the bound");
  CHECK(worst < 1);
}

TEST_CASE("a whole power is its product") {
  CHECK(whole_power(-3, 3) == -27);
  CHECK(whole_power(10, 22) == 1e22);
  CHECK(whole_power(0, 0) == 1);
  CHECK(whole_power(kNan, 0) == 1);
  CHECK(power_of_ten(0) == 1);
  CHECK(power_of_ten(22) == 1e22);
  for (const auto& [n, value] : {std::pair{-1, 1e-1}, {-5, 1e-5}, {-9, 1e-9}, {-22, 1e-22}})
    CHECK(power_of_ten(n) == value);
}

TEST_CASE("the cube root errs by less than two ulps, and not at all for small cubes") {
  WorstError worst;
  for (const double x : positive_numbers()) {
    worst.add(x, cube_root(x), boost::multiprecision::cbrt(Exact(x)));
    CHECK(cube_root(-x) == -cube_root(x));
  }
  INFO("worst " << worst.ulps << " ulps at " << worst.argument);
  CHECK(worst.ulps < 2);
  for (int i = 0; i <= 1000; ++i) CHECK(cube_root(double(i) * i * i) == i);
}

TEST_CASE("the hypotenuse errs by less than its bound, whatever the sizes") {
  Random random(44);
  WorstError two, three;
  for (int i = 0; i < 30000; ++i) {
    const int size = i % 3 == 0 ? int(random.integer(-1000, 1000)) : 0;
    const auto number = [&] { return random.scaled(-1, 1, size - 20, size + 20); };
    const double x = number(), y = number(), z = number();
    const Exact squares = Exact(x) * Exact(x) + Exact(y) * Exact(y);
    two.add(x, hypotenuse(x, y), sqrt(squares));
    three.add(x, hypotenuse(x, y, z), sqrt(Exact(squares + Exact(z) * Exact(z))));
  }
  INFO("of two " << two.ulps << " ulps at " << two.argument << ", of three " << three.ulps << " at "
                 << three.argument);
  CHECK(two.ulps < 2);
  CHECK(three.ulps < 2.5);
  CHECK(hypotenuse(3, 4) == 5);
  CHECK(hypotenuse(3 * kSmallest, 4 * kSmallest) == 5 * kSmallest);
  CHECK(hypotenuse(kLargest, 1) == kLargest);
}

TEST_CASE("what has no logarithm, power or root is said as IEEE 754 says it") {
  CHECK(logarithm(0) == -kInfinity);
  CHECK(logarithm(-0.0) == -kInfinity);
  CHECK(logarithm(kInfinity) == kInfinity);
  CHECK(std::isnan(logarithm(-1)));
  CHECK(std::isnan(logarithm(kNan)));
  CHECK(logarithm_2(0) == -kInfinity);
  CHECK(exponential(0) == 1);
  CHECK(exponential(kInfinity) == kInfinity);
  CHECK(exponential(-kInfinity) == 0);
  CHECK(exponential(710) == kInfinity);
  CHECK(std::isnan(exponential(kNan)));
  CHECK(power(0, 2.4) == 0);
  CHECK(std::isnan(power(-1, 2)));
  CHECK(std::signbit(cube_root(-0.0)));
  CHECK(cube_root(-kInfinity) == -kInfinity);
  CHECK(hypotenuse(-kInfinity, kNan) == kInfinity);
  CHECK(std::isnan(hypotenuse(1, kNan)));
  CHECK(hypotenuse(0, -0.0) == 0);
}

}  // namespace
}  // namespace glassbox
