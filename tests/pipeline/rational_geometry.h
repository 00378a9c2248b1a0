// Clip space in rational arithmetic (study/oracle/clip.h), over Boost's own rationals.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

#include "study/oracle/clip.h"

namespace glassbox::test {

using Rational = boost::multiprecision::cpp_rational;
using RationalPoint = study::oracle::ExactPoint<Rational>;
using RationalPolygon = study::oracle::ExactPolygon<Rational>;
using study::oracle::clip;
using study::oracle::distance;
using study::oracle::twice_ndc_area;

inline RationalPoint exactly(const Point<Clip>& p) {
  return study::oracle::exact_point<Rational>(p);
}
template <class Polygon>
RationalPolygon exactly(const Polygon& polygon) {
  return study::oracle::exact_polygon<Rational>(polygon);
}

}  // namespace glassbox::test
