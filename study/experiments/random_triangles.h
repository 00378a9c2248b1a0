// Triangles of a given kind and size on the screen, the same in every run.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <glassbox/base/trig.h>
#include <glassbox/mesh/builtin/images.h>
#include <glassbox/raster/triangle_setup.h>

namespace glassbox::study {

enum class Shape { kCompact, kSliver };

// The centres are spread over a square from (0, 0) with this side, in px.
inline constexpr int kShapesSide = 256;

// Triangle `index` of a stream: three corners around a random centre. Compact triangles have their
// corners on a circle of diameter `size_px`, a third of a turn apart, plus or minus a sixth.
// Slivers are `size_px` long and half a pixel wide, in any direction.
inline std::array<ScreenVertex, 3> random_triangle(Shape shape, double size_px,
                                                   std::uint64_t stream, std::uint64_t index,
                                                   float depth = 0.5f) {
  const auto draw = [&](std::uint64_t k) { return random_unit(stream, 16 * index + k); };
  const double x = kShapesSide * draw(0), y = kShapesSide * draw(1), turn = 2 * kPi * draw(2);
  std::array<ScreenVertex, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    double along, across;
    if (shape == Shape::kCompact) {
      const SinCos at = sin_cos(turn + 2 * kPi / 3 * (double(k) + draw(3 + k) - 0.5));
      along = at.cos * size_px / 2, across = at.sin * size_px / 2;
    } else {
      const SinCos at = sin_cos(turn);
      const double s = k == 0 ? -size_px / 2 : size_px / 2, t = k == 2 ? 0.5 : 0;
      along = s * at.cos - t * at.sin, across = s * at.sin + t * at.cos;
    }
    corners[k].position = {float(x + along), float(y + across), depth};
  }
  return corners;
}

// The triangles among `count` that still have an area after snapping. The last triangle is the
// nearest.
inline std::vector<TriangleSetup> random_triangles(Shape shape, double size_px,
                                                   std::uint64_t stream, int count) {
  std::vector<TriangleSetup> triangles;
  for (int i = 0; i < count; ++i) {
    const float depth = 1 - float(i + 1) / float(count + 1);
    if (const auto setup =
            setup_triangle(random_triangle(shape, size_px, stream, std::uint64_t(i), depth)))
      triangles.push_back(*setup);
  }
  return triangles;
}

}  // namespace glassbox::study
