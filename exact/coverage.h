// Decides which pixels a snapped triangle covers, in any integer type N that is wide enough:
// differences of coordinates have up to 25 bits, so the difference of two products of them has up
// to 25 + 25 + 1 bits and a sign.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include <glassbox/pipeline/stages.h>
#include <glassbox/raster/stages.h>

namespace glassbox::exact {

using SnappedTriangle = std::array<SnappedVertex, 3>;

// Rounds the vertex to subpixels (1/256 pixel): floor(256 v + 1/2) for each coordinate v. In double
// the result is exact for every float v below 2^16 pixels.
inline SnappedVertex snapped(const ScreenVertex& vertex) {
  const auto subpixels = [](float pixels) {
    return std::int32_t(std::floor(double(pixels) * kSubpixels + 0.5));
  };
  return {subpixels(vertex.position.x), subpixels(vertex.position.y)};
}
inline SnappedTriangle snapped(const std::array<ScreenVertex, 3>& t) {
  return {snapped(t[0]), snapped(t[1]), snapped(t[2])};
}

// The direction in which three points turn on a screen whose y points down, which is the sign of
// their area: 1 is clockwise, a back face; -1 is counter-clockwise; 0 means on one line or in one
// point. The type N has to be wide enough for products of two differences of coordinates.
template <class N, class P>
int orientation(const P& a, const P& b, const P& c) {
  const N one = (N(b.x) - N(a.x)) * (N(c.y) - N(a.y)),
          other = (N(c.x) - N(a.x)) * (N(b.y) - N(a.y));
  return (one > other) - (one < other);
}
template <class N>
int orientation(const SnappedTriangle& t) {
  return orientation<N>(t[0], t[1], t[2]);
}

// (b - a) x (p - a), where p is the centre of pixel (x, y).
template <class N>
N cross_at(const SnappedVertex& a, const SnappedVertex& b, std::int64_t x, std::int64_t y) {
  const N px = N(x) * N(kSubpixels) + N(kPixelCentre) - N(a.x);
  const N py = N(y) * N(kSubpixels) + N(kPixelCentre) - N(a.y);
  return (N(b.x) - N(a.x)) * py - (N(b.y) - N(a.y)) * px;
}

// The top-left rule in another form: the sample is moved right and down by (e, e^2), where e is
// infinitely small. Then it is on no edge, and it is inside if it is on the same side of all three
// edges. So the function needs neither the triangle's orientation nor a list of which edges are top
// or left edges.
template <class N>
bool covers(const SnappedTriangle& t, std::int64_t x, std::int64_t y) {
  int sides[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const SnappedVertex& a = t[k];
    const SnappedVertex& b = t[(k + 1) % 3];
    const N cross = cross_at<N>(a, b, x, y);
    const std::int64_t by_x = std::int64_t(a.y) - b.y;  // the derivative of `cross` by x
    const std::int64_t by_y = std::int64_t(b.x) - a.x;
    const auto sign = [](const auto& n) { return (n > 0) - (n < 0); };
    sides[k] = cross != 0 ? sign(cross) : by_x != 0 ? sign(by_x) : sign(by_y);
  }
  return sides[0] != 0 && sides[0] == sides[1] && sides[1] == sides[2];
}

}  // namespace glassbox::exact
