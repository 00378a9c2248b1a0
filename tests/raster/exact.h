// Exact arithmetic and plain builders for the raster tests.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <ostream>

#include <glassbox/raster/snap.h>
#include <glassbox/raster/triangle_setup.h>

namespace glassbox::test {

__extension__ typedef __int128 Int128;
using Rational = boost::multiprecision::cpp_rational;

inline Rational abs_of(const Rational& x) {
  return x < 0 ? Rational(-x) : x;
}

// k roundings of relative size u = 2^-24, to all orders: k u / (1 - k u).
inline Rational gamma(int k) {
  const Rational ku = Rational(k) / (1 << 24);
  return ku / (1 - ku);
}

// A screen vertex at (x, y) / 256 pixels; exact for |x|, |y| <= 2^24, so snapping gives back x and y.
inline ScreenVertex screen_vertex(std::int64_t x, std::int64_t y, float depth = 0.5f,
                                  float inverse_w = 1.0f) {
  return {{float(x) / float(kSubpixels), float(y) / float(kSubpixels), depth}, inverse_w};
}

using SnappedTriangle = std::array<SnappedVertex, 3>;

inline std::array<ScreenVertex, 3> screen_triangle(const SnappedTriangle& t) {
  return {screen_vertex(t[0].x, t[0].y), screen_vertex(t[1].x, t[1].y),
          screen_vertex(t[2].x, t[2].y)};
}

inline std::ostream& operator<<(std::ostream& out, const SnappedTriangle& t) {
  out << "in 1/256 px:";
  for (const SnappedVertex& v : t) out << " (" << v.x << ", " << v.y << ")";
  return out;
}

// (b - a) x (p - a) for the centre of pixel (x, y).
inline Int128 cross_at(const SnappedVertex& a, const SnappedVertex& b, std::int64_t x,
                       std::int64_t y) {
  const Int128 px = Int128(x) * 256 + 128 - a.x;
  const Int128 py = Int128(y) * 256 + 128 - a.y;
  return (Int128(b.x) - a.x) * py - (Int128(b.y) - a.y) * px;
}

// The top-left rule said differently: the sample is moved by (e, e^2), e infinitely small, to the right and down; then
// it lies on no edge, and is inside where it lies on the same side of all three. No orientation, no edge classes.
inline bool covers_exactly(const SnappedTriangle& t, std::int64_t x, std::int64_t y) {
  int sides[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const SnappedVertex& a = t[k];
    const SnappedVertex& b = t[(k + 1) % 3];
    const Int128 cross = cross_at(a, b, x, y);
    const std::int64_t by_x = std::int64_t(a.y) - b.y;  // d cross / d x
    const std::int64_t by_y = std::int64_t(b.x) - a.x;
    const auto sign = [](auto n) { return (n > 0) - (n < 0); };
    sides[k] = cross != 0 ? sign(cross) : by_x != 0 ? sign(by_x) : sign(by_y);
  }
  return sides[0] != 0 && sides[0] == sides[1] && sides[1] == sides[2];
}

}  // namespace glassbox::test
