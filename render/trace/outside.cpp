#include <glassbox/render/trace/outside.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <glassbox/raster/snap.h>

namespace glassbox {

// Two convex figures have no area in common if and only if the line through a side of one of them separates them.
std::optional<Outside> outside_of(const TracedPiece& piece, const PixelRect& picture) {
  const std::array<SnappedVertex, 3> v{snap(piece.vertices[0]), snap(piece.vertices[1]),
                                       snap(piece.vertices[2])};
  const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
  const std::int64_t x0 = std::int64_t(picture.x0) * kSubpixels;
  const std::int64_t x1 = std::int64_t(picture.x1) * kSubpixels;
  const std::int64_t y0 = std::int64_t(picture.y0) * kSubpixels;
  const std::int64_t y1 = std::int64_t(picture.y1) * kSubpixels;
  if (right <= x0 || left >= x1 || bottom <= y0 || top >= y1) {
    const auto beyond = [](std::int64_t by) { return std::max<std::int64_t>(by, 0); };
    return Outside{
        beyond(x0 - right), beyond(y0 - bottom), beyond(left - x1), beyond(top - y1), {}};
  }
  for (const EdgeFunction& edge : piece.setup->edges) {
    std::int64_t nearest = std::numeric_limits<std::int64_t>::min();
    for (const std::int64_t x : {x0, x1}) {
      for (const std::int64_t y : {y0, y1}) nearest = std::max(nearest, edge.at(x, y));
    }
    if (nearest > 0) continue;
    Outside outside;
    outside.beyond_edge = -double(nearest) / std::hypot(double(edge.a), double(edge.b));
    return outside;
  }
  return std::nullopt;
}

}  // namespace glassbox
