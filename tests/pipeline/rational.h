// The exact oracle (study/oracle) over Boost's own rationals: headers of tests may show the library.
#pragma once

#include <tests/support/random.h>

#include <boost/multiprecision/cpp_int.hpp>

#include "study/oracle/matrix.h"

namespace glassbox::test {

using Rational = boost::multiprecision::cpp_rational;
using RationalMatrix = study::oracle::Matrix4<Rational>;
using RationalVector = study::oracle::Vector4<Rational>;
using study::oracle::pythagorean_rotation;
using study::oracle::PythagoreanRotation;

// The very numbers of a matrix.
template <class Matrix>
RationalMatrix exactly(const Matrix& m) {
  return study::oracle::exactly<Rational>(m);
}

inline double error_of(double value, const Rational& exact) {
  return double(Rational(abs(Rational(value) - exact)));
}

}  // namespace glassbox::test
