#include <glassbox/render/trace/coverage_miss.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <glassbox/base/elementary.h>
#include <glassbox/pipeline/clip.h>
#include <glassbox/raster/snap.h>

namespace glassbox {

namespace {

// Finds the edge that the pixel's centre is furthest outside of; the distance is negative if the
// centre is inside all edges. As a function of x this distance is convex, because it is the largest
// of three linear functions.
CentreMiss furthest_outside(const TriangleSetup& triangle, int x, int y) {
  const std::int64_t centre_x = std::int64_t(x) * kSubpixels + kPixelCentre;
  const std::int64_t centre_y = std::int64_t(y) * kSubpixels + kPixelCentre;
  CentreMiss miss{x, y, 0, 0, -std::numeric_limits<double>::infinity()};
  for (std::size_t k = 0; k < 3; ++k) {
    const EdgeFunction& edge = triangle.edges[k];
    const std::int64_t value = edge.at(centre_x, centre_y);
    const double outside = -double(value) / hypotenuse(double(edge.a), double(edge.b));
    const bool unowned_tie = outside == miss.subpixels && value == 0 && !edge.owns_zero;
    if (outside > miss.subpixels || unowned_tie) {
      miss.edge = k;
      miss.value = value;
      miss.subpixels = outside + 0.0;  // + 0.0 turns -0 into 0
    }
  }
  return miss;
}

CentreMiss nearest_in_row(const TriangleSetup& triangle, int x0, int x1, int y) {
  while (x1 - x0 > 1) {
    const int middle = x0 + (x1 - x0) / 2;
    const bool falling = furthest_outside(triangle, middle, y).subpixels <
                         furthest_outside(triangle, middle - 1, y).subpixels;
    (falling ? x0 : x1) = middle;
  }
  return furthest_outside(triangle, x0, y);
}

// The planes through the eye and the edges of the rectangle, a pixel outside of it. What lies
// between them has w >= 0.
std::array<ClipPlane, 4> sides_of(const PixelRect& pixels, const Viewport& window) {
  const double half_width = double(window.width()) / 2, half_height = double(window.height()) / 2;
  const double centre_x = double(window.left) + half_width;
  const double centre_y = double(window.top) + half_height;
  return {{{half_width, 0, 0, centre_x - (pixels.x0 - 1), 0, "left"},
           {-half_width, 0, 0, pixels.x1 + 1 - centre_x, 0, "right"},
           {0, -half_height, 0, centre_y - (pixels.y0 - 1), 0, "top"},
           {0, half_height, 0, pixels.y1 + 1 - centre_y, 0, "bottom"}}};
}

}  // namespace

bool contains(const PixelRect& pixels, int x, int y) {
  return x >= pixels.x0 && x < pixels.x1 && y >= pixels.y0 && y < pixels.y1;
}

PixelRect pixels_touched(std::span<const ScreenVertex> vertices) {
  PixelRect box{std::numeric_limits<int>::max(), std::numeric_limits<int>::max(),
                std::numeric_limits<int>::min(), std::numeric_limits<int>::min()};
  for (const ScreenVertex& vertex : vertices) {
    // The guard band keeps positions well inside the range of int.
    const int x = int(std::floor(vertex.position.x)), y = int(std::floor(vertex.position.y));
    box = {std::min(box.x0, x), std::min(box.y0, y), std::max(box.x1, x + 1),
           std::max(box.y1, y + 1)};
  }
  return box;
}

bool would_reach(const std::array<ClipVertex, 3>& corners, const Viewport& window,
                 const PixelRect& pixels) {
  const std::array<ClipPlane, 4> sides = sides_of(pixels, window);
  std::array<Outcode, 3> codes;
  for (std::size_t k = 0; k < 3; ++k) codes[k] = outcode(corners[k].position, sides);
  const ClipVerdict verdict = trivial_verdict(codes);
  if (verdict != ClipVerdict::kClip) return verdict == ClipVerdict::kAccept;
  return clip_triangle(corners, sides).count > 0;
}

std::optional<CentreMiss> miss_at(const TriangleSetup& triangle, int x, int y) {
  const CentreMiss miss = furthest_outside(triangle, x, y);
  if (triangle.edges[miss.edge].covers(miss.value)) return std::nullopt;
  return miss;
}

CentreMiss nearest_miss(const TriangleSetup& triangle, const PixelRect& pixels) {
  CentreMiss nearest;
  nearest.subpixels = std::numeric_limits<double>::infinity();
  for (int y = pixels.y0; y < pixels.y1; ++y) {
    const CentreMiss miss = nearest_in_row(triangle, pixels.x0, pixels.x1, y);
    if (miss.subpixels < nearest.subpixels) nearest = miss;
  }
  return nearest;
}

// Returns by how much the triangle is outside the picture. Two convex figures have no area in
// common if and only if the line through a side of one of them separates them; so the sides of the
// picture and the edges of the triangle are tested.
std::optional<OutsideDistances> outside_distances(const TracedPiece& piece,
                                                  const PixelRect& picture) {
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
    return OutsideDistances{
        beyond(x0 - right), beyond(y0 - bottom), beyond(left - x1), beyond(top - y1), {}};
  }
  for (const EdgeFunction& edge : piece.setup->edges) {
    std::int64_t nearest = std::numeric_limits<std::int64_t>::min();
    for (const std::int64_t x : {x0, x1}) {
      for (const std::int64_t y : {y0, y1}) nearest = std::max(nearest, edge.at(x, y));
    }
    if (nearest > 0) continue;
    OutsideDistances outside;
    outside.beyond_edge = -double(nearest) / hypotenuse(double(edge.a), double(edge.b));
    return outside;
  }
  return std::nullopt;
}

}  // namespace glassbox
