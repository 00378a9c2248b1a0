// The exact oracle: matrices of rationals, and rotations that are rational too (SPEC C.9).
#pragma once

#include <tests/support/random.h>

#include <array>
#include <boost/multiprecision/cpp_int.hpp>

#include <glassbox/base/spaces.h>

namespace glassbox::test {

using Rational = boost::multiprecision::cpp_rational;

struct RationalMatrix {
  std::array<std::array<Rational, 4>, 4> at{};  // [row][column]

  static RationalMatrix identity() {
    RationalMatrix m;
    for (std::size_t i = 0; i < 4; ++i) m.at[i][i] = 1;
    return m;
  }
};

using RationalVector = std::array<Rational, 4>;

inline RationalMatrix operator*(const RationalMatrix& a, const RationalMatrix& b) {
  RationalMatrix product;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 4; ++k) product.at[i][j] += a.at[i][k] * b.at[k][j];
    }
  }
  return product;
}

inline RationalVector operator*(const RationalMatrix& m, const RationalVector& v) {
  RationalVector product;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 4; ++k) product[i] += m.at[i][k] * v[k];
  }
  return product;
}

// The very numbers of a matrix of doubles or floats.
template <class Target, class Source, class T>
RationalMatrix exactly(const Transform<Target, Source, T>& m) {
  RationalMatrix exact;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j)
      exact.at[std::size_t(i)][std::size_t(j)] = Rational(double(m.at(i, j)));
  }
  return exact;
}

inline double error_of(double value, const Rational& exact) {
  return double(Rational(abs(Rational(value) - exact)));
}

// A rotation by the quaternion (a, b, c, d) of small integers: all entries are integers over a^2 + b^2 + c^2 + d^2.
struct PythagoreanRotation {
  std::int64_t denominator = 1;
  std::array<std::array<std::int64_t, 3>, 3> numerator{};  // [row][column]
};

inline PythagoreanRotation pythagorean_rotation(Random& random, std::int64_t size = 9) {
  std::int64_t a = 0, b = 0, c = 0, d = 0;
  while (a == 0 && b == 0 && c == 0 && d == 0) {
    a = random.integer(-size, size);
    b = random.integer(-size, size);
    c = random.integer(-size, size);
    d = random.integer(-size, size);
  }
  PythagoreanRotation r;
  r.denominator = a * a + b * b + c * c + d * d;
  r.numerator = {{{a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
                  {2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)},
                  {2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d}}};
  return r;
}

inline RationalMatrix exactly(const PythagoreanRotation& r) {
  RationalMatrix m = RationalMatrix::identity();
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) m.at[i][j] = Rational(r.numerator[i][j], r.denominator);
  }
  return m;
}

}  // namespace glassbox::test
