// Outlines with integer coordinates, whose areas and turns are exact, and random simple ones.
#pragma once

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <glassbox/base/random.h>
#include "tests/mesh/polygons.h"

namespace glassbox::test {

struct Int2 {
  std::int64_t x, y;
  bool operator==(const Int2&) const = default;
};
using Outline = std::vector<Int2>;

inline std::int64_t turn(const Int2& a, const Int2& b, const Int2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

inline bool on_segment(const Int2& p, const Int2& a, const Int2& b) {
  return turn(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
         std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}

inline int sign(std::int64_t v) {
  return (v > 0) - (v < 0);
}

inline bool segments_meet(const Int2& a, const Int2& b, const Int2& c, const Int2& d) {
  if (on_segment(a, c, d) || on_segment(b, c, d) || on_segment(c, a, b) || on_segment(d, a, b))
    return true;
  return sign(turn(a, b, c)) * sign(turn(a, b, d)) < 0 &&
         sign(turn(c, d, a)) * sign(turn(c, d, b)) < 0;
}

// The first two edges that meet where they must not, or (n, n) if the polygon is simple.
inline std::pair<std::size_t, std::size_t> find_crossing(const Outline& p) {
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Int2 &a = p[i], &b = p[(i + 1) % n], &after = p[(i + 2) % n];
    if (on_segment(after, a, b) || on_segment(a, b, after)) return {i, (i + 1) % n};
    for (std::size_t j = i + 2; j < n; ++j) {
      if ((j + 1) % n != i && segments_meet(a, b, p[j], p[(j + 1) % n])) return {i, j};
    }
  }
  return {n, n};
}

inline std::int64_t twice_area(const Outline& p) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Int2 &a = p[i], &b = p[(i + 1) % p.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

// Random points, untangled by reversing the part of the outline between two edges that cross. Empty
// if that does not end.
inline Outline random_simple(Random& random, std::size_t n, int range) {
  Outline p;
  while (p.size() < n) {
    const Int2 q = {random.integer(-range, range), random.integer(-range, range)};
    if (std::find(p.begin(), p.end(), q) == p.end()) p.push_back(q);
  }
  for (int step = 0; step < 200; ++step) {
    const auto [i, j] = find_crossing(p);
    if (i == n) {
      if (twice_area(p) < 0) std::reverse(p.begin(), p.end());
      return p;
    }
    std::reverse(p.begin() + std::ptrdiff_t(std::min(i, j)) + 1,
                 p.begin() + std::ptrdiff_t(std::max(i, j)) + 1);
    // Reversing does not untangle neighbouring edges that overlap; moving a point may.
    if (j == i + 1) std::swap(p[j], p[std::size_t(random.integer(0, std::int64_t(n) - 1))]);
  }
  return {};
}

inline Mesh flat_mesh(const Outline& outline) {
  std::vector<Point<Object>> points;
  for (const Int2& p : outline) points.emplace_back(float(p.x), float(p.y), 0.0f);
  return make_polygon(std::move(points));
}

inline std::string text(const Outline& outline) {
  std::ostringstream out;
  for (const Int2& p : outline) out << '(' << p.x << ", " << p.y << ") ";
  return out.str();
}

}  // namespace glassbox::test
