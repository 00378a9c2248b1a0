// Compares the exact predicates with rational arithmetic, on inputs made to mislead doubles.
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include <glassbox/base/expansion.h>
#include <glassbox/base/random.h>

#include "tests/support/catch.h"

namespace {

using glassbox::Exact2;
using glassbox::Exact3;
using glassbox::Expansion;
using glassbox::Random;
using Rational = boost::multiprecision::cpp_rational;

int sign_of(double x) {
  return (x > 0) - (x < 0);
}

template <int N>
Rational value_of(const Expansion<N>& e) {
  Rational sum = 0;
  for (int i = 0; i < e.count; ++i) sum += Rational(e.terms[std::size_t(i)]);
  return sum;
}

// Returns a double with a random number of significant bits and a size between 2^low and 2^high.
double random_double(Random& random, int low, int high) {
  const int bits = int(random.integer(1, 53));
  const double mantissa = double(random.integer(1, (std::int64_t{1} << bits) - 1));
  const int exponent = int(random.integer(low, high)) - bits;
  const double x = std::ldexp(mantissa, exponent);
  return random.integer(0, 1) == 0 ? x : -x;
}

Rational orient2d(const Exact2& a, const Exact2& b, const Exact2& c) {
  const auto r = [](double x) { return Rational(x); };
  return (r(a[0]) - r(c[0])) * (r(b[1]) - r(c[1])) - (r(a[1]) - r(c[1])) * (r(b[0]) - r(c[0]));
}

Rational orient3d(const Exact3& a, const Exact3& b, const Exact3& c, const Exact3& d) {
  std::array<Rational, 3> p, q, r;
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = Rational(a[i]) - Rational(d[i]);
    q[i] = Rational(b[i]) - Rational(d[i]);
    r[i] = Rational(c[i]) - Rational(d[i]);
  }
  return p[2] * (q[0] * r[1] - q[1] * r[0]) + q[2] * (r[0] * p[1] - r[1] * p[0]) +
         r[2] * (p[0] * q[1] - p[1] * q[0]);
}

// The determinant computed with doubles alone, with their round-off.
double rounded_orient2d(const Exact2& a, const Exact2& b, const Exact2& c) {
  return (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0]);
}

}  // namespace

TEST_CASE("two_sum and two_product lose nothing") {
  const std::uint64_t seed = 1;
  INFO("seed " << seed);
  Random random(seed);
  for (int i = 0; i < 20000; ++i) {
    const double a = random_double(random, -190, 200), b = random_double(random, -190, 200);
    CAPTURE(a, b);
    const glassbox::TwoTerms sum = glassbox::two_sum(a, b);
    REQUIRE(sum.high == a + b);
    REQUIRE(Rational(sum.high) + Rational(sum.low) == Rational(a) + Rational(b));
    const glassbox::TwoTerms product = glassbox::two_product(a, b);
    REQUIRE(product.high == a * b);
    REQUIRE(Rational(product.high) + Rational(product.low) == Rational(a) * Rational(b));
  }
}

TEST_CASE("sums and products of expansions are exact, and their terms do not overlap") {
  const std::uint64_t seed = 2;
  INFO("seed " << seed);
  Random random(seed);
  for (int i = 0; i < 5000; ++i) {
    const int spread = i % 2 == 0 ? 3 : 150;
    const auto number = [&] { return random_double(random, -spread, spread); };
    const double a = number(), b = number(), c = number(), d = number(), e = number();
    CAPTURE(a, b, c, d, e);
    const auto exact = (glassbox::exact_product(a, b) - glassbox::exact_product(c, d)) *
                           glassbox::exact_difference(e, a) +
                       glassbox::exact_difference(b, e) * c;
    const Rational expected =
        (Rational(a) * Rational(b) - Rational(c) * Rational(d)) * (Rational(e) - Rational(a)) +
        (Rational(b) - Rational(e)) * Rational(c);
    REQUIRE(value_of(exact) == expected);
    REQUIRE(exact.sign() == expected.sign());
    REQUIRE(sign_of(exact.estimate()) == expected.sign());
    for (int k = 1; k < exact.count; ++k) {
      // Each term has to be smaller than the lowest bit of the next one.
      const double smaller = std::abs(exact.terms[std::size_t(k - 1)]);
      int exponent;
      double mantissa = std::frexp(exact.terms[std::size_t(k)], &exponent);
      while (mantissa != std::floor(mantissa)) {
        mantissa *= 2;
        --exponent;
      }
      while (std::floor(mantissa / 2) * 2 == mantissa) {
        mantissa /= 2;
        ++exponent;
      }
      REQUIRE(smaller < std::ldexp(1.0, exponent));
    }
  }
}

TEST_CASE("what cancels exactly is zero, and has no terms") {
  const double a = 0x1.fffffffffffffp150, b = 0x1.0000000000001p-150;
  const auto zero = glassbox::exact_product(a, b) - glassbox::exact_product(b, a);
  CHECK(zero.count == 0);
  CHECK(zero.sign() == 0);
  CHECK(zero.estimate() == 0);
}

TEST_CASE("the turn of three nearly collinear points is right where doubles say otherwise (B.2)") {
  // Points within a few ulps of a line through (12, 12) and (24, 24): the classroom example of
  // Kettner et al.
  int wrong_in_doubles = 0;
  for (int i = 0; i < 64; ++i) {
    for (int j = 0; j < 64; ++j) {
      const Exact2 a{0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53}, b{12, 12}, c{24, 24};
      const int exact = orient2d(a, b, c).sign();
      CAPTURE(i, j);
      REQUIRE(glassbox::sign_of_orient2d(a, b, c) == exact);
      wrong_in_doubles += sign_of(rounded_orient2d(a, b, c)) != exact;
    }
  }
  CHECK(wrong_in_doubles > 100);  // with fewer, the case would be too easy
}

TEST_CASE("orientations in the plane and in space have the signs of rational arithmetic") {
  const std::uint64_t seed = 3;
  INFO("seed " << seed);
  Random random(seed);
  int zeros = 0, plane_fallbacks = 0;
  for (int i = 0; i < 6000; ++i) {
    const int kind = i % 3;
    std::array<Exact3, 4> p;
    for (Exact3& point : p) {
      for (double& x : point) {
        // Three kinds: lattice points, which are often coplanar; sizes that differ by 2^300;
        // ordinary numbers.
        if (kind == 0) x = double(random.integer(-3, 3));
        if (kind == 1) x = random.integer(0, 4) == 0 ? 0 : random_double(random, -140, 200);
        if (kind == 2) x = random.between(-1, 1);
      }
    }
    if (kind == 2) {
      // The fourth point is in the plane of the others but for round-off, so that round-off decides
      // the sign of the naive determinant.
      const double s = random.unit(), t = random.unit() * (1 - s);
      for (std::size_t k = 0; k < 3; ++k) {
        p[3][k] = p[0][k] * (1 - s - t) + p[1][k] * s + p[2][k] * t;
      }
    }
    CAPTURE(i);
    const int expected = orient3d(p[0], p[1], p[2], p[3]).sign();
    zeros += expected == 0;
    REQUIRE(glassbox::sign_of_orient3d(p[0], p[1], p[2], p[3]) == expected);
    REQUIRE(glassbox::sign_of_orient3d(p[1], p[0], p[2], p[3]) == -expected);

    const Exact2 a{p[0][0], p[0][1]}, b{p[1][0], p[1][1]};
    const double s = random.unit();
    const Exact2 c = kind == 2 ? Exact2{a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])}
                               : Exact2{p[2][0], p[2][1]};
    const int turn = orient2d(a, b, c).sign();
    plane_fallbacks += kind == 2 && turn != sign_of(rounded_orient2d(a, b, c));
    REQUIRE(glassbox::sign_of_orient2d(a, b, c) == turn);
    REQUIRE(glassbox::sign_of_orient2d(b, a, c) == -turn);
  }
  CHECK(zeros > 50);
  CHECK(plane_fallbacks > 50);
}

TEST_CASE("seen from a point d, a clockwise triangle is positive") {
  CHECK(glassbox::sign_of_orient2d({0, 0}, {1, 0}, {0, 1}) == 1);
  // The triangle is counter-clockwise seen from above, and hence clockwise seen from below.
  CHECK(glassbox::sign_of_orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}) == 1);
  CHECK(glassbox::sign_of_orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}) == -1);
}

TEST_CASE("a sum of products has the exact sign") {
  const std::uint64_t seed = 4;
  INFO("seed " << seed);
  Random random(seed);
  int wrong_in_doubles = 0;
  for (int i = 0; i < 20000; ++i) {
    const int n = int(random.integer(1, glassbox::kMaxProducts));
    std::array<double, glassbox::kMaxProducts> a{}, b{};
    for (int k = 0; k < n; ++k) {
      a[std::size_t(k)] = random_double(random, -2, 2);
      b[std::size_t(k)] = random_double(random, -2, 2);
    }
    if (n >= 2 && i % 2 == 0) {
      // The last product cancels the first one almost completely.
      a[std::size_t(n - 1)] = -a[0];
      b[std::size_t(n - 1)] = b[0] * (1 + double(random.integer(-1, 1)) * 0x1p-52);
      for (int k = 1; k + 1 < n; ++k) a[std::size_t(k)] *= 0x1p-60;
    }
    Rational exact = 0;
    double naive = 0;
    for (std::size_t k = 0; k < std::size_t(n); ++k) {
      exact += Rational(a[k]) * Rational(b[k]);
      naive += a[k] * b[k];
    }
    const double sum =
        glassbox::sum_of_products({a.data(), std::size_t(n)}, {b.data(), std::size_t(n)});
    CAPTURE(i, n);
    REQUIRE(sign_of(sum) == exact.sign());
    wrong_in_doubles += sign_of(naive) != exact.sign();
  }
  CHECK(wrong_in_doubles > 100);
}
