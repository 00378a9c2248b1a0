// The number types of the exact oracle, compared with one another: all other tests rely on them.
#include "exact/number.h"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <glassbox/base/random.h>
#include "exact/coverage.h"
#include "exact/matrix.h"
#include "tests/support/catch.h"

using namespace glassbox;
using namespace glassbox::exact;
using glassbox::Random;

namespace {

// Boost's 50-digit binary float has 168 bits, so an operation errs by at most 2^-168 of its result.
constexpr double kDecimalRoundoff = 0x1p-168;

double any_double(Random& random) {
  return random.scaled(-1, 1, -300, 300);
}

}  // namespace

TEST_CASE("rationals and 50 digits give the same sums, products and quotients of doubles") {
  const std::uint64_t seed = 701;
  INFO("seed " << seed);
  Random random(seed);
  for (int i = 0; i < 5000; ++i) {
    const double a = any_double(random), b = any_double(random), c = any_double(random);
    CAPTURE(i, a, b, c);
    // Three operations; the terms of the sum may cancel.
    const Rational exact = (Rational(a) * Rational(b) + Rational(c)) / Rational(b);
    const Decimal decimal = (Decimal(a) * Decimal(b) + Decimal(c)) / Decimal(b);
    const Rational size = (abs(Rational(a) * Rational(b)) + abs(Rational(c))) / abs(Rational(b));
    const Decimal difference = abs(decimal - decimal_from(exact));
    REQUIRE(difference <= Decimal(4 * kDecimalRoundoff) * decimal_from(size));
    REQUIRE(double(exact) == Approx(double(decimal)).epsilon(1e-15));
    REQUIRE((exact.sign() == decimal.sign() || std::abs(double(exact)) <= 1e-50 * double(size)));
  }
}

TEST_CASE("integers of 128 bits and rationals agree on what 128 bits hold") {
  const std::uint64_t seed = 702;
  INFO("seed " << seed);
  Random random(seed);
  for (int i = 0; i < 5000; ++i) {
    const auto number = [&] {
      return random.integer(-1, 0) * 2 + 1 > 0 ? random.integer(0, std::int64_t(1) << 41)
                                               : -random.integer(0, std::int64_t(1) << 41);
    };
    const std::int64_t a = number(), b = number(), c = number(), d = number();
    CAPTURE(i, a, b, c, d);
    // At most 3 * 41 bits and a sign: the numerators of the depth plane are no wider.
    const Integer whole = Integer(a) * Integer(b) * Integer(c) - Integer(d);
    const Rational exact = Rational(a) * Rational(b) * Rational(c) - Rational(d);
    REQUIRE(rational_from(whole) == exact);
    REQUIRE(whole.sign() == exact.sign());
    REQUIRE(double(whole) == double(exact));
    REQUIRE(whole.text() == exact.text());
    REQUIRE((whole < Integer(d)) == (exact < Rational(d)));
  }
}

TEST_CASE("coverage is the same in 128-bit integers, rationals and 50 digits") {
  const std::uint64_t seed = 703;
  INFO("seed " << seed);
  Random random(seed);
  int inside = 0, on_an_edge = 0;
  for (int i = 0; i < 400; ++i) {
    SnappedTriangle t;
    // On odd rounds the coordinates are multiples of half a pixel: many edges then run through
    // pixel centres.
    for (SnappedVertex& v : t) {
      const auto coordinate = [&] {
        return i % 2 == 0 ? std::int32_t(random.integer(-(1 << 24), 1 << 24))
                          : std::int32_t(random.integer(-8, 24) * 128);
      };
      v = {coordinate(), coordinate()};
    }
    for (int y = 0; y < 8; ++y) {
      for (int x = 0; x < 8; ++x) {
        const bool covered = covers<Integer>(t, x, y);
        REQUIRE(covers<Rational>(t, x, y) == covered);
        REQUIRE(covers<Decimal>(t, x, y) == covered);
        inside += covered;
        on_an_edge += cross_at<Integer>(t[0], t[1], x, y) == 0;
      }
    }
  }
  CHECK(inside > 1000);
  CHECK(on_an_edge > 50);
}

TEST_CASE("every double goes in and comes out unchanged, the smallest and the largest included") {
  const double awkward[] = {0.0,
                            1.0,
                            0x1p-1074,
                            -0x1p-1074,
                            0x1p-1022,
                            0.1,
                            1.0 / 3,
                            0x1p1023,
                            0x1.fffffffffffffp1023,
                            -0x1.fffffffffffffp1023,
                            0x1p-53,
                            1 + 0x1p-52,
                            1 - 0x1p-53};
  for (const double value : awkward) {
    CAPTURE(value);
    CHECK(double(Rational(value)) == value);
    CHECK(double(Decimal(value)) == value);
    CHECK(double(Rational(value) - Rational(value)) == 0);
    if (value == std::trunc(value) && std::abs(value) < 0x1p127)
      CHECK(double(Integer(value)) == value);
  }
  const std::uint64_t seed = 704;
  INFO("seed " << seed);
  Random random(seed);
  for (int i = 0; i < 2000; ++i) {
    const double value = random.scaled(-1, 1, -1060, 1020);
    REQUIRE(double(Rational(value)) == value);
    REQUIRE(double(Decimal(value)) == value);
  }
}

TEST_CASE("cancellation that leaves a double nothing leaves the oracle everything") {
  // (2^60 + 1) - 2^60, and (1 + 2^-80)(1 - 2^-80) - 1 = -2^-160.
  CHECK(double(Rational(0x1p60) + Rational(1) - Rational(0x1p60)) == 1);
  CHECK(double(Integer(0x1p60) + Integer(1) - Integer(0x1p60)) == 1);
  const double e = 0x1p-80;
  const Rational product = (Rational(1) + Rational(e)) * (Rational(1) - Rational(e)) - Rational(1);
  const Decimal decimal = (Decimal(1) + Decimal(e)) * (Decimal(1) - Decimal(e)) - Decimal(1);
  CHECK(double(product) == -e * e);
  CHECK(double(decimal) == -e * e);  // needs 160 of the 168 bits
  CHECK((1 + e) * (1 - e) - 1 == 0);
}

TEST_CASE("what has no answer throws, and never wraps round or becomes NaN") {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double value : {infinity, -infinity, std::nan("")}) {
    CHECK_THROWS_AS(Rational(value), std::domain_error);
    CHECK_THROWS_AS(Decimal(value), std::domain_error);
    CHECK_THROWS_AS(Integer(value), std::domain_error);
    CHECK(error_of(value, Rational(1)) == infinity);
    CHECK(error_of(value, Decimal(1)) == infinity);
  }
  CHECK_THROWS_AS(Integer(0.5), std::range_error);
  CHECK_THROWS_AS(Integer(0x1p127), std::range_error);
  Integer large(0x1p126);
  CHECK_THROWS(large * Integer(4));
  CHECK_THROWS_AS(Rational(1) / Rational(0), std::overflow_error);
  CHECK_THROWS_AS(Decimal(1) / Decimal(0), std::overflow_error);
  CHECK_THROWS_AS(Integer(1) / Integer(0), std::overflow_error);
  CHECK_THROWS_AS(sqrt(Decimal(-1)), std::domain_error);
}

TEST_CASE("roots and angles of 50 digits satisfy their identities to 50 digits") {
  const std::uint64_t seed = 705;
  INFO("seed " << seed);
  Random random(seed);
  const Decimal tolerance(1e-48);
  for (int i = 0; i < 200; ++i) {
    const Decimal x(random.between(1e-9, 3));
    CAPTURE(double(x));
    CHECK(abs(sqrt(x) * sqrt(x) / x - Decimal(1)) <= tolerance);
    CHECK(abs(sin(x) * sin(x) + cos(x) * cos(x) - Decimal(1)) <= tolerance);
    CHECK(abs(atan2(sin(x), cos(x)) - x) <= tolerance);
    CHECK(abs(tan(x) * cos(x) - sin(x)) <= tolerance * (Decimal(1) + abs(tan(x))));
  }
  CHECK(double(pi()) == 3.141592653589793238463);
  CHECK(abs(sin(pi())) <= tolerance);
}

TEST_CASE(
    "a rotation of small integers is exactly orthogonal in rationals, to 50 digits in digits") {
  const std::uint64_t seed = 706;
  INFO("seed " << seed);
  Random random(seed);
  const auto transposed = [](auto m) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < i; ++j) std::swap(m.at[i][j], m.at[j][i]);
    }
    return m;
  };
  for (int i = 0; i < 100; ++i) {
    const PythagoreanRotation r = pythagorean_rotation(random);
    const auto rational = exactly<Rational>(r) * transposed(exactly<Rational>(r));
    const auto decimal = exactly<Decimal>(r) * transposed(exactly<Decimal>(r));
    for (std::size_t row = 0; row < 4; ++row) {
      for (std::size_t column = 0; column < 4; ++column) {
        const int expected = row == column ? 1 : 0;
        REQUIRE(rational.at[row][column] == Rational(expected));
        // Three products of entries below 1, whose factors were rounded before: 16 roundings at
        // most.
        REQUIRE(abs(decimal.at[row][column] - Decimal(expected)) <= Decimal(16 * kDecimalRoundoff));
      }
    }
  }
}

TEST_CASE("three points turn one way, the other way when two change places, and no way on a line") {
  const SnappedVertex a{0, 0}, b{256, 0}, c{0, 256};  // with y down: to the right, then down
  CHECK(orientation<std::int64_t>(a, b, c) == 1);
  CHECK(orientation<Integer>(a, c, b) == -1);
  CHECK(orientation<Rational>(b, c, a) == 1);
  CHECK(orientation<std::int64_t>(a, a, b) == 0);
  CHECK(orientation<std::int64_t>(SnappedVertex{-3, -3}, SnappedVertex{0, 0},
                                  SnappedVertex{7, 7}) == 0);
  // One step beside the line between opposite corners of the largest picture: the turn needs 50
  // bits.
  const std::int32_t far = 1 << 24;
  CHECK(orientation<std::int64_t>(SnappedVertex{-far, -far}, SnappedVertex{far, far},
                                  SnappedVertex{0, 1}) == 1);
  CHECK(orientation<std::int64_t>(SnappedVertex{-far, -far}, SnappedVertex{far, far},
                                  SnappedVertex{1, 0}) == -1);
}

TEST_CASE("positions are snapped to the nearest 1/256 px, halves upwards") {
  const auto snapped_x = [](float x) { return snapped(ScreenVertex{{x, 0, 0}, 1}).x; };
  CHECK(snapped_x(1.0f) == 256);
  CHECK(snapped_x(0x1p-9f) == 1);
  CHECK(snapped_x(-0x1p-9f) == 0);
  CHECK(snapped_x(-0x1.8p-8f) == -1);
  CHECK(snapped_x(std::nextafter(0x1p-9f, 0.0f)) == 0);
}
