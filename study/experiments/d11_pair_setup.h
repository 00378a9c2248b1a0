// Sets up a triangle for both eyes; values that are the same for both eyes are computed once.
//
// The eyes are separated along x only (S0-03). So a corner's y, depth and w are the same in both
// pictures, and so are the slopes of the edges along x, the rows, and the interpolated values. Each
// eye has its own x, slopes along y, area and columns.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <glassbox/pipeline/divide.h>
#include <glassbox/raster/fan.h>
#include <glassbox/raster/snap.h>
#include <glassbox/raster/triangle_setup.h>

#include "study/experiments/d10_methods.h"

namespace glassbox::study::d11 {

using SetUp = std::optional<TriangleSetup>;

// A triangle on the screens of both eyes.
struct PairTriangle {
  std::array<ScreenVertex, 3> left, right;
};

inline std::array<SetUp, 2> set_up_each(const PairTriangle& t) {
  return {setup_triangle(t.left), setup_triangle(t.right)};
}

// Has the same result as setup_triangle, but uses y, depth and w of the left eye for both eyes.
class SharedSetup {
public:
  explicit SharedSetup(const std::array<ScreenVertex, 3>& corners) : corners_(corners) {
    for (std::size_t k = 0; k < 3; ++k) y_[k] = snap(corners[k].position.y);
    const auto [top, bottom] = std::minmax({y_[0], y_[1], y_[2]});
    y0_ = first_pixel(top), y1_ = end_pixel(bottom);
    const auto depth_of = [&](std::size_t vertex) { return corners[vertex].position.z; };
    for (std::size_t k = 1; k < 3; ++k) {
      if (depth_of(k) < depth_of(nearest_)) nearest_ = k;
    }
    affine_ = corners[0].inverse_w == corners[1].inverse_w &&
              corners[1].inverse_w == corners[2].inverse_w;
  }

  SetUp operator()(const std::array<ScreenVertex, 3>& eye) const {
    const std::array<std::int32_t, 3> x{snap(eye[0].position.x), snap(eye[1].position.x),
                                        snap(eye[2].position.x)};
    const std::int64_t area = double_area<std::int64_t>({x[0], x[1], x[2]}, {y_[0], y_[1], y_[2]});
    if (area == 0) return std::nullopt;
    TriangleSetup setup;
    setup.clockwise = area > 0;
    setup.double_area = setup.clockwise ? area : -area;
    // If several corners are equally near, the first one in the order of this eye is used.
    const std::size_t step = setup.clockwise ? 1 : 2;
    std::size_t first = nearest_;
    if (!setup.clockwise && nearest_ == 1 && corners_[2].position.z == corners_[1].position.z)
      first = 2;
    for (std::size_t k = 0; k < 3; ++k) setup.order[k] = int((first + k * step) % 3);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = std::size_t(setup.order[k]), from = std::size_t(setup.order[(k + 1) % 3]),
                 to = std::size_t(setup.order[(k + 2) % 3]);
      const EdgeSlopes<std::int64_t> slopes{y_[from] - std::int64_t(y_[to]),
                                            x[to] - std::int64_t(x[from])};
      setup.edges[k] = {slopes.a, slopes.b,
                        edge_value<std::int64_t>(slopes, x[from], y_[from], 0, 0),
                        owns_its_points(slopes)};
      setup.depth[k] = corners_[at].position.z;
      setup.inverse_w[k] = corners_[at].inverse_w;
    }
    setup.affine = affine_;
    setup.inverse_area = 1.0f / float(setup.double_area);
    const auto [left, right] = std::minmax({x[0], x[1], x[2]});
    setup.bounds = {first_pixel(left), y0_, end_pixel(right), y1_};
    return setup;
  }

private:
  const std::array<ScreenVertex, 3>& corners_;
  std::array<std::int32_t, 3> y_{};
  int y0_ = 0, y1_ = 0;
  std::size_t nearest_ = 0;
  bool affine_ = false;
};

inline std::array<SetUp, 2> set_up_shared(const PairTriangle& t) {
  const SharedSetup shared(t.left);
  return {shared(t.left), shared(t.right)};
}

inline bool are_same(const SetUp& a, const SetUp& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  const auto same_edges = [](const EdgeFunction& e, const EdgeFunction& f) {
    return e.a == f.a && e.b == f.b && e.c == f.c && e.owns_zero == f.owns_zero;
  };
  return std::ranges::equal(a->edges, b->edges, same_edges) && a->double_area == b->double_area &&
         a->clockwise == b->clockwise && a->order == b->order && a->depth == b->depth &&
         a->inverse_w == b->inverse_w && a->affine == b->affine &&
         a->inverse_area == b->inverse_area && a->bounds.x0 == b->bounds.x0 &&
         a->bounds.y0 == b->bounds.y0 && a->bounds.x1 == b->bounds.x1 &&
         a->bounds.y1 == b->bounds.y1;
}

// The triangles that no clip plane of either eye cuts.
inline std::vector<PairTriangle> pair_triangles(const d10::Eyes& eyes) {
  std::vector<PairTriangle> all;
  for (std::size_t i = 0; i < eyes.list.draws.size(); ++i) {
    const Draw& draw = eyes.list.draws[i];
    for (const Triangle& triangle : draw.triangulation->triangles) {
      PairTriangle pair;
      Outcode outside{};
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t index = draw.mesh->corners[triangle.corners[k]].position;
        outside |= eyes.left_clip[i].outcodes[index] | eyes.right_clip[i].outcodes[index];
        if (outside != 0) break;
        pair.left[k] = to_screen(divide(eyes.left_clip[i].positions[index]), eyes.left.viewport);
        pair.right[k] = to_screen(divide(eyes.right_clip[i].positions[index]), eyes.right.viewport);
      }
      if (outside == 0) all.push_back(pair);
    }
  }
  return all;
}

}  // namespace glassbox::study::d11
