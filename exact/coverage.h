// Which pixels a snapped triangle covers, in any integers that are wide enough: 2 (25 + 25) bits and a sign.
#pragma once

#include <array>
#include <cstdint>

#include <glassbox/raster/stages.h>

namespace glassbox::exact {

using SnappedTriangle = std::array<SnappedVertex, 3>;

// (b - a) x (p - a) for the centre of pixel (x, y).
template <class N>
N cross_at(const SnappedVertex& a, const SnappedVertex& b, std::int64_t x, std::int64_t y) {
  const N px = N(x) * N(kSubpixels) + N(kPixelCentre) - N(a.x);
  const N py = N(y) * N(kSubpixels) + N(kPixelCentre) - N(a.y);
  return (N(b.x) - N(a.x)) * py - (N(b.y) - N(a.y)) * px;
}

// The top-left rule said differently: the sample is moved by (e, e^2), e infinitely small, to the right and down; then
// it lies on no edge, and is inside where it lies on the same side of all three. No orientation, no edge classes.
template <class N>
bool covers(const SnappedTriangle& t, std::int64_t x, std::int64_t y) {
  int sides[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const SnappedVertex& a = t[k];
    const SnappedVertex& b = t[(k + 1) % 3];
    const N cross = cross_at<N>(a, b, x, y);
    const std::int64_t by_x = std::int64_t(a.y) - b.y;  // d cross / d x
    const std::int64_t by_y = std::int64_t(b.x) - a.x;
    const auto sign = [](const auto& n) { return (n > 0) - (n < 0); };
    sides[k] = cross != 0 ? sign(cross) : by_x != 0 ? sign(by_x) : sign(by_y);
  }
  return sides[0] != 0 && sides[0] == sides[1] && sides[1] == sides[2];
}

}  // namespace glassbox::exact
