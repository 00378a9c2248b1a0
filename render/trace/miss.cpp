#include <glassbox/render/trace/miss.h>

#include <cmath>
#include <limits>

namespace glassbox {

namespace {

// The edge whose line the centre lies furthest outside of, negative inside of all. As a function of x it is convex: the
// largest of three linear functions.
Miss furthest_outside(const TriangleSetup& triangle, int x, int y) {
  const std::int64_t centre_x = std::int64_t(x) * kSubpixels + kPixelCentre;
  const std::int64_t centre_y = std::int64_t(y) * kSubpixels + kPixelCentre;
  Miss miss{x, y, 0, 0, -std::numeric_limits<double>::infinity()};
  for (std::size_t k = 0; k < 3; ++k) {
    const EdgeFunction& edge = triangle.edges[k];
    const std::int64_t value = edge.at(centre_x, centre_y);
    const double outside = -double(value) / std::hypot(double(edge.a), double(edge.b));
    const bool unowned_tie = outside == miss.subpixels && value == 0 && !edge.owns_zero;
    if (outside > miss.subpixels || unowned_tie) {
      miss.edge = k;
      miss.value = value;
      miss.subpixels = outside + 0.0;  // never -0
    }
  }
  return miss;
}

Miss nearest_in_row(const TriangleSetup& triangle, int x0, int x1, int y) {
  while (x1 - x0 > 1) {
    const int middle = x0 + (x1 - x0) / 2;
    const bool falling = furthest_outside(triangle, middle, y).subpixels <
                         furthest_outside(triangle, middle - 1, y).subpixels;
    (falling ? x0 : x1) = middle;
  }
  return furthest_outside(triangle, x0, y);
}

}  // namespace

std::optional<Miss> miss_at(const TriangleSetup& triangle, int x, int y) {
  const Miss miss = furthest_outside(triangle, x, y);
  if (triangle.edges[miss.edge].covers(miss.value)) return std::nullopt;
  return miss;
}

Miss nearest_miss(const TriangleSetup& triangle, const PixelRect& pixels) {
  Miss nearest;
  nearest.subpixels = std::numeric_limits<double>::infinity();
  for (int y = pixels.y0; y < pixels.y1; ++y) {
    const Miss miss = nearest_in_row(triangle, pixels.x0, pixels.x1, y);
    if (miss.subpixels < nearest.subpixels) nearest = miss;
  }
  return nearest;
}

}  // namespace glassbox
