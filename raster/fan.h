// Chooses the vertex from which a clipped polygon is split into a fan of triangles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <glassbox/raster/formulas.h>
#include <glassbox/raster/stages.h>

namespace glassbox {

// Twice the signed area; positive when a, b, c run clockwise as seen on the screen (y points down).
// The result is exact, because the factors have at most 26 bits.
inline std::int64_t double_area(const SnappedVertex& a, const SnappedVertex& b,
                                const SnappedVertex& c) {
  return double_area<std::int64_t>({a.x, b.x, c.x}, {a.y, b.y, c.y});
}

// Returns the first vertex whose fan (apex, apex + i + 1, apex + i + 2) has no two triangles of
// opposite winding. Snapping may bend a convex polygon inwards a little; the fan from vertex 0
// could then fold back on itself and cover pixels twice. Returns 0 if there is no such vertex,
// which happens only for a sliver that crosses itself.
inline int fan_apex(std::span<const SnappedVertex> polygon) {
  const int count = int(polygon.size());
  const auto vertex = [&](int i) { return polygon[std::size_t(i % count)]; };
  for (int apex = 0; apex < count; ++apex) {
    bool clockwise = false;
    bool counter_clockwise = false;
    for (int i = 1; i + 1 < count; ++i) {
      const std::int64_t area = double_area(vertex(apex), vertex(apex + i), vertex(apex + i + 1));
      clockwise = clockwise || area > 0;
      counter_clockwise = counter_clockwise || area < 0;
    }
    if (!(clockwise && counter_clockwise)) return apex;
  }
  return 0;
}

// The vertices of triangle i = 0 .. count - 3 in the fan of a polygon with `count` vertices.
inline std::array<std::size_t, 3> fan_vertices(int apex, int count, int i) {
  return {std::size_t(apex), std::size_t((apex + i + 1) % count),
          std::size_t((apex + i + 2) % count)};
}

}  // namespace glassbox
