// The edges of the edge-arithmetic experiment (D-3), and the ways to test a pixel centre against an
// edge.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/raster/stages.h>

#include "study/experiments/kernels/edge_kernels.h"

namespace glassbox::study {

// ---- an edge, and a pixel centre within half a pixel of it ----

struct EdgeSample {
  SnappedVertex from, to;
  std::int32_t x = 0, y = 0;  // pixel centre, in 1/256 px

  EdgeSample reversed() const { return {to, from, x, y}; }
  std::int64_t dx() const { return to.x - from.x; }
  std::int64_t dy() const { return to.y - from.y; }
  // The longer side of the edge's bounding box. The edge function E divided by it is the distance
  // from the edge along the other axis.
  std::int64_t major() const { return std::max(std::abs(dx()), std::abs(dy())); }
  // Points on top and left edges belong to the triangle, as in the pipeline.
  bool owns_zero() const { return dy() < 0 || (dy() == 0 && dx() > 0); }
};

inline std::int32_t nearest_centre(std::int64_t subpixels) {
  return std::int32_t((subpixels & ~std::int64_t(kSubpixels - 1)) + kPixelCentre);
}

// An edge with random ends in a square of `width` px, and a pixel in a random row or column that
// the edge crosses.
inline EdgeSample random_edge_sample(Random& random, int width) {
  const std::int64_t side = std::int64_t(width) * kSubpixels - 1;
  const auto anywhere = [&] { return std::int32_t(random.integer(0, side)); };
  while (true) {
    EdgeSample s{{anywhere(), anywhere()}, {anywhere(), anywhere()}};
    if (s.major() < kSubpixels) continue;
    const double t = random.unit();
    if (std::abs(s.dx()) == s.major()) {
      s.x = nearest_centre(s.from.x + std::int64_t(t * double(s.dx())));
      s.y = nearest_centre(s.from.y + (s.x - s.from.x) * s.dy() / s.dx());
    } else {
      s.y = nearest_centre(s.from.y + std::int64_t(t * double(s.dy())));
      s.x = nearest_centre(s.from.x + (s.y - s.from.y) * s.dx() / s.dy());
    }
    return s;
  }
}

// Whether the pixel belongs to the triangle on the right of the edge, if the edge function has this
// value.
template <class T>
bool covers(T edge, const EdgeSample& s) {
  return edge > 0 || (edge == 0 && s.owns_zero());
}

// Whether the pixel is covered, computed in 128 bits from the unchanged corners.
inline bool right_decision(const EdgeSample& s) {
  __extension__ using Wide = __int128;
  const Wide e = (Wide(s.to.x) - s.from.x) * (Wide(s.y) - s.from.y) -
                 (Wide(s.to.y) - s.from.y) * (Wide(s.x) - s.from.x);
  return covers(e, s);
}

// ---- the methods ----

// The edge function E = dx (y - y0) - dy (x - x0), exact because the factors have 24 bits.
inline std::int64_t exact_edge(const EdgeSample& s) {
  return s.dx() * (s.y - s.from.y) - s.dy() * (s.x - s.from.x);
}

// The edge function in float. All coordinates and their differences are exact; only the products
// and the last subtraction are rounded.
inline float float_difference(const EdgeSample& s) {
  const float right = float(s.x) - float(s.from.x), down = float(s.y) - float(s.from.y);
  return float(s.dx()) * down - float(s.dy()) * right;
}
inline float float_fma(const EdgeSample& s) {
  const float right = float(s.x) - float(s.from.x), down = float(s.y) - float(s.from.y);
  return std::fma(-float(s.dy()), right, float(s.dx()) * down);
}
// The edge function as E = a x + b y + c. If the ends of the edge are exchanged, a, b and c = x0 y1
// - x1 y0 only change their signs, so both triangles at the edge have the same |E|.
template <class T>
T plane(const EdgeSample& s) {
  const T a = -T(s.dy()), b = T(s.dx());
  const T c = T(s.from.x) * T(s.to.y) - T(s.to.x) * T(s.from.y);
  return (a * T(s.x) + b * T(s.y)) + c;
}
// Returns (E - bias)/256, rounded down, from its value at the corner of the tile that contains the
// pixel. E is the edge function; bias is 1 if points on the edge belong to the neighbour, otherwise
// 0. The result is >= 0 if and only if E - bias is >= 0. In a tile of 64 px next to the edge it is
// less than 2 * 2^23 * 2^6 = 2^30, so 32 bits are enough.
inline std::int32_t int32_tile(const EdgeSample& s) {
  const std::int32_t tile = kEdgeTile * kSubpixels;
  const std::int32_t column = s.x % tile / kSubpixels, row = s.y % tile / kSubpixels;
  EdgeSample corner = s;
  corner.x -= column * kSubpixels, corner.y -= row * kSubpixels;
  const auto start = std::int32_t((exact_edge(corner) - (s.owns_zero() ? 0 : 1)) >> kSubpixelBits);
  return start - std::int32_t(s.dy()) * column + std::int32_t(s.dx()) * row;
}

inline bool covers_centre(EdgeArithmetic arithmetic, const EdgeSample& s) {
  switch (arithmetic) {
    case EdgeArithmetic::kFloatDifference:
      return covers(float_difference(s), s);
    case EdgeArithmetic::kFloatPlane:
      return covers(plane<float>(s), s);
    case EdgeArithmetic::kFloatFma:
      return covers(float_fma(s), s);
    case EdgeArithmetic::kDouble:
      return covers(plane<double>(s), s);
    case EdgeArithmetic::kInt32Tile:
      return int32_tile(s) >= 0;
    case EdgeArithmetic::kInt64:
      break;
  }
  return covers(exact_edge(s), s);
}

// ---- what is timed ----

// Triangles with a corner in a tile; the tile is anywhere on a screen of this width.
inline std::vector<TileEdges> timed_triangles(int width, int count) {
  Random random(4);
  std::vector<TileEdges> triangles;
  const std::int64_t far = std::int64_t(width) * kSubpixels / 2;
  for (int i = 0; i < count; ++i) {
    TileEdges t;
    std::array<std::int32_t, 3> x, y;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t reach = k == 0 ? kEdgeTile * kSubpixels / 2 : far;
      x[k] = std::int32_t(random.integer(-reach, reach));
      y[k] = std::int32_t(random.integer(-reach, reach));
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      t.x0[k] = x[k], t.y0[k] = y[k], t.dx[k] = x[next] - x[k], t.dy[k] = y[next] - y[k];
    }
    triangles.push_back(t);
  }
  return triangles;
}

}  // namespace glassbox::study
