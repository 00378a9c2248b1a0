// Clip space in rational arithmetic (exact/clip.h), with Boost's own rationals.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

#include "exact/clip.h"

namespace glassbox::test {

using Rational = boost::multiprecision::cpp_rational;
using RationalPoint = exact::ExactPoint<Rational>;
using RationalPolygon = exact::ExactPolygon<Rational>;
using exact::clip;
using exact::distance;
using exact::twice_ndc_area;

inline RationalPoint rational_of(const Point<Clip>& p) {
  return exact::exact_point<Rational>(p);
}
template <class Polygon>
RationalPolygon rational_of(const Polygon& polygon) {
  return exact::exact_polygon<Rational>(polygon);
}

}  // namespace glassbox::test
