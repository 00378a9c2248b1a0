// Rasterizers with errors: each part of the correct one (snapping, edge functions, tie rule) can be
// replaced by a wrong one.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "study/extremes/common/coverage.h"

namespace glassbox::study::naive {

// ---- float edge functions ----

// Computes the cross product in float from positions that are not snapped, and counts >= 0 as
// "inside", as most tutorials do. Rounding gives the two triangles of an edge different answers,
// and both draw the pixels whose centres are exactly on the edge.
inline void float_covers(const ScreenTriangle& t, const PixelRect& window,
                         const PixelVisitor& visit) {
  const auto cross = [](const Point<Screen>& a, const Point<Screen>& b, float x, float y) {
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
  };
  const Point<Screen>&a = t[0].position, &b = t[1].position, &c = t[2].position;
  const float turn = cross(a, b, c.x, c.y) < 0 ? -1.0f : 1.0f;
  const auto [left, right] = std::minmax({a.x, b.x, c.x});
  const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
  for (int y = std::max(window.y0, int(top) - 1); y < std::min(window.y1, int(bottom) + 2); ++y) {
    for (int x = std::max(window.x0, int(left) - 1); x < std::min(window.x1, int(right) + 2); ++x) {
      const float px = float(x) + 0.5f, py = float(y) + 0.5f;
      if (cross(a, b, px, py) * turn >= 0 && cross(b, c, px, py) * turn >= 0 &&
          cross(c, a, px, py) * turn >= 0) {
        visit(x, y);
      }
    }
  }
}

// The formula and the tie rule are right, but the edge function is computed in float, from
// differences to the first vertex of the edge. The neighbouring triangle starts the same edge at
// its other vertex, so it rounds differently.
inline bool float_difference_inside(const SnappedVertex& a, const SnappedVertex& b, int x, int y,
                                    bool owns_zero) {
  const float ax = float(a.x) / 256, ay = float(a.y) / 256;
  const float bx = float(b.x) / 256, by = float(b.y) / 256;
  const float edge = (bx - ax) * (float(y) + 0.5f - ay) - (by - ay) * (float(x) + 0.5f - ax);
  return edge > 0 || (edge == 0 && owns_zero);
}

// Computes the edge function in 32 bits. They are enough for a picture of 2048 pixels with 4
// subpixel bits; with 8 subpixel bits, the edge function overflows and wraps around.
inline bool int32_inside(const SnappedVertex& a, const SnappedVertex& b, int x, int y,
                         bool owns_zero) {
  const auto wrapped = [](std::int64_t n) { return std::int64_t(std::int32_t(std::uint32_t(n))); };
  const std::int64_t first = wrapped(std::int64_t(b.x - a.x) * (y * 256 + 128 - a.y));
  const std::int64_t second = wrapped(std::int64_t(b.y - a.y) * (x * 256 + 128 - a.x));
  const std::int64_t edge = wrapped(first - second);
  return edge > 0 || (edge == 0 && owns_zero);
}

inline bool exact_inside(const SnappedVertex& a, const SnappedVertex& b, int x, int y,
                         bool owns_zero) {
  const std::int64_t edge = std::int64_t(b.x - a.x) * (std::int64_t(y) * 256 + 128 - a.y) -
                            std::int64_t(b.y - a.y) * (std::int64_t(x) * 256 + 128 - a.x);
  return edge > 0 || (edge == 0 && owns_zero);
}

// ---- the right rasterizer in parts ----

// Whether a point exactly on the edge from a to b belongs to the triangle, whose vertices run
// clockwise on the screen (top-left rule).
inline bool top_left(const SnappedVertex& a, const SnappedVertex& b) {
  return a.y > b.y || (a.y == b.y && b.x > a.x);
}

struct CoverageParts {
  std::int32_t (*snap)(float pixels) = glassbox::snap;
  bool (*inside)(const SnappedVertex& a, const SnappedVertex& b, int x, int y,
                 bool owns_zero) = exact_inside;
  bool (*owns)(const SnappedVertex& a, const SnappedVertex& b) = top_left;
  // True (a mistake): the tie rule is applied before the triangle is turned clockwise.
  bool rule_before_orientation = false;
};

// Covers the same pixels as pipeline_covers if no part is exchanged.
inline void covers_with(const CoverageParts& parts, const ScreenTriangle& t,
                        const PixelRect& window, const PixelVisitor& visit) {
  SnappedTriangle v;
  for (std::size_t k = 0; k < 3; ++k) {
    v[k] = {parts.snap(t[k].position.x), parts.snap(t[k].position.y)};
  }
  const std::int64_t area = std::int64_t(v[1].x - v[0].x) * (v[2].y - v[0].y) -
                            std::int64_t(v[2].x - v[0].x) * (v[1].y - v[0].y);
  if (area == 0) return;
  const bool turned = area < 0;
  if (turned) std::swap(v[1], v[2]);
  const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
  const int x0 = std::max(window.x0, (left >> 8) - 1), x1 = std::min(window.x1, (right >> 8) + 2);
  const int y0 = std::max(window.y0, (top >> 8) - 1), y1 = std::min(window.y1, (bottom >> 8) + 2);
  std::array<bool, 3> owns{};
  for (std::size_t k = 0; k < 3; ++k) {
    const SnappedVertex &a = v[k], &b = v[(k + 1) % 3];
    owns[k] = turned && parts.rule_before_orientation ? parts.owns(b, a) : parts.owns(a, b);
  }
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) {
      bool all = true;
      for (std::size_t k = 0; k < 3 && all; ++k) {
        all = parts.inside(v[k], v[(k + 1) % 3], x, y, owns[k]);
      }
      if (all) visit(x, y);
    }
  }
}

inline CoverageFunction covers_with(const CoverageParts& parts) {
  return [parts](const ScreenTriangle& t, const PixelRect& window, const PixelVisitor& visit) {
    covers_with(parts, t, window, visit);
  };
}

// ---- parts that go wrong ----

inline bool owns_all(const SnappedVertex&, const SnappedVertex&) {
  return true;
}
inline bool owns_none(const SnappedVertex&, const SnappedVertex&) {
  return false;
}
// The opposite of the top-left rule. It leaves no gaps and no overlaps, but picks other pixels than
// all other rasterizers.
inline bool bottom_right(const SnappedVertex& a, const SnappedVertex& b) {
  return !top_left(a, b);
}
// The tie rule without its "top" part: pixels exactly on horizontal edges belong to no triangle.
inline bool left_only(const SnappedVertex& a, const SnappedVertex& b) {
  return a.y > b.y;
}

// Snaps by truncating towards zero: positions left of column 0 move to the right instead of to the
// left.
inline std::int32_t snap_truncating(float pixels) {
  return std::int32_t(pixels * 256.0f);
}
// Snaps by rounding, with halves of a step rounded away from zero, as std::round does.
inline std::int32_t snap_away(float pixels) {
  return std::int32_t(std::round(pixels * 256.0f));
}
// Snaps by rounding, with halves of a step rounded to the even number, as processors do by default.
inline std::int32_t snap_to_even(float pixels) {
  return std::int32_t(std::nearbyint(pixels * 256.0f));
}
// Adds a half and rounds down, but the float sum is itself rounded: 0.49999997 steps become 1, and
// from 2^15 px on the half is lost.
inline std::int32_t snap_float_half(float pixels) {
  return std::int32_t(std::floor(pixels * 256.0f + 0.5f));
}

}  // namespace glassbox::study::naive
