// Exact arithmetic for the raster tests, and functions that build their inputs.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <ostream>

#include <glassbox/raster/snap.h>
#include <glassbox/raster/triangle_setup.h>

#include "exact/coverage.h"

namespace glassbox::test {

__extension__ typedef __int128 Int128;
using Rational = boost::multiprecision::cpp_rational;

inline Rational abs_of(const Rational& x) {
  return x < 0 ? Rational(-x) : x;
}

// The bound of k roundings of relative size u = 2^-24, to all orders: k u / (1 - k u).
inline Rational gamma(int k) {
  const Rational ku = Rational(k) / (1 << 24);
  return ku / (1 - ku);
}

// A screen vertex at (x, y) / 256 pixels; exact for |x|, |y| <= 2^24, so snapping returns x and y.
inline ScreenVertex screen_vertex(std::int64_t x, std::int64_t y, float depth = 0.5f,
                                  float inverse_w = 1.0f) {
  return {{float(x) / float(kSubpixels), float(y) / float(kSubpixels), depth}, inverse_w};
}

using exact::SnappedTriangle;

inline std::array<ScreenVertex, 3> screen_triangle(const SnappedTriangle& t) {
  return {screen_vertex(t[0].x, t[0].y), screen_vertex(t[1].x, t[1].y),
          screen_vertex(t[2].x, t[2].y)};
}

inline std::ostream& operator<<(std::ostream& out, const SnappedTriangle& t) {
  out << "in 1/256 px:";
  for (const SnappedVertex& v : t) out << " (" << v.x << ", " << v.y << ")";
  return out;
}

// The edge function of the coverage oracle, in the compiler's own wide integers, because tests
// evaluate it millions of times.
inline Int128 cross_at(const SnappedVertex& a, const SnappedVertex& b, std::int64_t x,
                       std::int64_t y) {
  return exact::cross_at<Int128>(a, b, x, y);
}
inline bool covers_exactly(const SnappedTriangle& t, std::int64_t x, std::int64_t y) {
  return exact::covers<Int128>(t, x, y);
}

}  // namespace glassbox::test
