#include <glassbox/raster/triangle_setup.h>

#include <algorithm>
#include <utility>

#include <glassbox/raster/fan.h>
#include <glassbox/raster/snap.h>

namespace glassbox {

namespace {

EdgeFunction edge_function(const SnappedVertex& from, const SnappedVertex& to) {
  const auto slopes = edge_slopes<std::int64_t>(from.x, from.y, to.x, to.y);
  return {slopes.a, slopes.b, edge_value<std::int64_t>(slopes, from.x, from.y, 0, 0),
          owns_its_points(slopes)};
}

}  // namespace

PixelRect pixels_in_box(const std::array<SnappedVertex, 3>& v) {
  const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
  return {first_pixel(left), first_pixel(top), end_pixel(right), end_pixel(bottom)};
}

PixelRect intersect(const PixelRect& a, const PixelRect& b) {
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

std::optional<TriangleSetup> setup_triangle(const std::array<ScreenVertex, 3>& vertices) {
  return setup_triangle(vertices, {snap(vertices[0]), snap(vertices[1]), snap(vertices[2])});
}

std::optional<TriangleSetup> setup_triangle(const std::array<ScreenVertex, 3>& vertices,
                                            const std::array<SnappedVertex, 3>& snapped) {
  const std::int64_t area = double_area(snapped[0], snapped[1], snapped[2]);
  if (area == 0) return std::nullopt;

  TriangleSetup setup;
  setup.clockwise = area > 0;
  setup.double_area = setup.clockwise ? area : -area;
  setup.order = {0, 1, 2};
  if (!setup.clockwise) std::swap(setup.order[1], setup.order[2]);

  // The vertex of smallest depth comes first: interpolate.h says why.
  const auto depth_of = [&](int vertex) { return vertices[std::size_t(vertex)].position.z; };
  const auto nearest = std::min_element(setup.order.begin(), setup.order.end(),
                                        [&](int a, int b) { return depth_of(a) < depth_of(b); });
  std::rotate(setup.order.begin(), nearest, setup.order.end());

  for (std::size_t k = 0; k < 3; ++k) {
    const auto vertex = [&](std::size_t corner) { return std::size_t(setup.order[corner % 3]); };
    setup.edges[k] = edge_function(snapped[vertex(k + 1)], snapped[vertex(k + 2)]);
    setup.depth[k] = vertices[vertex(k)].position.z;
    setup.inverse_w[k] = vertices[vertex(k)].inverse_w;
  }
  setup.affine =
      setup.inverse_w[0] == setup.inverse_w[1] && setup.inverse_w[1] == setup.inverse_w[2];
  setup.inverse_area = 1.0f / float(setup.double_area);
  setup.bounds = pixels_in_box(snapped);
  return setup;
}

}  // namespace glassbox
