// Lab 6: your part. student.h says what each function must do, handout.md why.
#include "student.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lab_06 {

// ---- task 6.1: onto the grid ----

std::int32_t snap(float pixels) {
  // BEGIN SOLUTION
  // Exact in double: a float has 24 bits, and a sum that is rounded is not near an integer.
  return std::int32_t(std::floor(double(pixels) * kSteps + 0.5));
  // STUB: return -0x7fffffff;  // in steps of 1/256 pixel
  // END SOLUTION
}

// ---- task 6.2: on which side of an edge ----

std::int64_t edge(const SnappedVertex& a, const SnappedVertex& b, const SnappedVertex& p) {
  // BEGIN SOLUTION
  // The differences have 25 bits and a sign, the products 50 bits, and their difference 51.
  return std::int64_t(b.x - a.x) * (p.y - a.y) - std::int64_t(b.y - a.y) * (p.x - a.x);
  // STUB: return 0;  // positive where a, b, p run clockwise on the screen
  // END SOLUTION
}

// ---- task 6.3: who owns a shared edge ----

bool owns_edge(const SnappedVertex& a, const SnappedVertex& b) {
  // BEGIN SOLUTION
  const bool left = b.y < a.y;  // in a clockwise triangle, left edges go up and top edges go right
  const bool top = a.y == b.y && b.x > a.x;
  return left || top;
  // STUB: return false;  // top and left edges
  // END SOLUTION
}

// ---- task 6.4: coverage ----

// BEGIN SOLUTION
namespace {

// The triangle with its corners in clockwise order. Its area is not zero.
Triangle clockwise(Triangle t) {
  if (edge(t[0], t[1], t[2]) < 0) std::swap(t[1], t[2]);
  return t;
}

SnappedVertex centre_of(int x, int y) {
  return {x * kSteps + kCentre, y * kSteps + kCentre};
}

bool covers(const SnappedVertex& a, const SnappedVertex& b, const SnappedVertex& centre) {
  const std::int64_t e = edge(a, b, centre);
  return e > 0 || (e == 0 && owns_edge(a, b));
}

// The first pixel whose centre is at or after `low`. Shifting right rounds down, also for negative
// numbers.
int first_pixel(std::int32_t low) {
  return (low + kCentre - 1) >> 8;
}

}  // namespace
// STUB:
// END SOLUTION

std::vector<Pixel> covered_pixels(const Triangle& triangle, const PixelRect& window) {
  // BEGIN SOLUTION
  std::vector<Pixel> pixels;
  if (edge(triangle[0], triangle[1], triangle[2]) == 0) return pixels;
  const Triangle t = clockwise(triangle);
  const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
  const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
  const int x0 = std::max(window.x0, first_pixel(left));
  const int y0 = std::max(window.y0, first_pixel(top));
  const int x1 = std::min(window.x1, first_pixel(right + 1));
  const int y1 = std::min(window.y1, first_pixel(bottom + 1));
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) {
      const SnappedVertex p = centre_of(x, y);
      if (covers(t[0], t[1], p) && covers(t[1], t[2], p) && covers(t[2], t[0], p))
        pixels.push_back({x, y});
    }
  }
  return pixels;
  // STUB: return {};  // the pixels of the window whose centres are covered
  // END SOLUTION
}

// ---- task 6.5: from which vertex to fan ----

int fan_apex(const std::vector<SnappedVertex>& polygon) {
  // BEGIN SOLUTION
  const std::size_t count = polygon.size();
  for (std::size_t k = 0; k < count; ++k) {
    bool forth = false, back = false;
    for (std::size_t i = 1; i + 1 < count; ++i) {
      const std::int64_t area =
          edge(polygon[k], polygon[(k + i) % count], polygon[(k + i + 1) % count]);
      forth = forth || area > 0;
      back = back || area < 0;
    }
    if (!(forth && back)) return int(k);
  }
  return 0;
  // STUB: return -1;  // the number of the vertex
  // END SOLUTION
}

// ---- task 6.6: whole tiles ----

TileCover classify_tile(const Triangle& triangle, const PixelRect& tile) {
  // BEGIN SOLUTION
  // An edge function is linear, so its extremes among the centres of a tile are at the four
  // corners.
  const Triangle t = clockwise(triangle);
  const std::array<SnappedVertex, 4> corners{
      centre_of(tile.x0, tile.y0), centre_of(tile.x1 - 1, tile.y0), centre_of(tile.x0, tile.y1 - 1),
      centre_of(tile.x1 - 1, tile.y1 - 1)};
  bool all = true;
  for (std::size_t k = 0; k < 3; ++k) {
    int inside = 0;
    for (const SnappedVertex& corner : corners) inside += covers(t[k], t[(k + 1) % 3], corner);
    if (inside == 0) return TileCover::kNone;
    all = all && inside == 4;
  }
  return all ? TileCover::kAll : TileCover::kSome;
  // STUB: return TileCover::kSome;  // kNone and kAll where they are certain
  // END SOLUTION
}

}  // namespace lab_06
