// The exact oracle (exact/matrix.h) with Boost's own rationals; headers of tests may include Boost.
#pragma once

#include <glassbox/base/random.h>

#include <boost/multiprecision/cpp_int.hpp>

#include "exact/matrix.h"

namespace glassbox::test {

using Rational = boost::multiprecision::cpp_rational;
using RationalMatrix = exact::Matrix4<Rational>;
using RationalVector = exact::Vector4<Rational>;
using exact::pythagorean_rotation;
using exact::PythagoreanRotation;

// The exact values of a matrix's entries.
template <class Matrix>
RationalMatrix exactly(const Matrix& m) {
  return exact::exactly<Rational>(m);
}

inline double error_of(double value, const Rational& exact) {
  return double(Rational(abs(Rational(value) - exact)));
}

}  // namespace glassbox::test
