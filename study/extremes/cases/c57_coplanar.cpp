#include "study/extremes/common/depth.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/far_panes.h"
#include "study/naive/depth.h"

#include <glassbox/base/random.h>

namespace glassbox::study {
namespace c57 {

constexpr int kSide = 4096;

// The depth of a plane, chosen so that floats hold it exactly at integer pixel coordinates.
double plane_at(double x, double y) {
  return 0.25 + x * 0x1p-14 + y * 0x1p-15;
}

ScreenTriangle random_triangle(Random& random) {
  ScreenTriangle t;
  for (ScreenVertex& v : t) {
    const double x = double(random.integer(0, kSide)), y = double(random.integer(0, kSide));
    v = screen_vertex(x, y, float(plane_at(x, y)));
  }
  return t;
}

Outcome measure_error(const DepthAt& depth) {
  Random random(57);
  ErrorsAboveBound errors(8);
  for (int i = 0; i < 300; ++i) {
    const auto setup = setup_triangle(random_triangle(random));
    if (!setup) continue;
    // Tests some whole rows of each triangle.
    for (int row = 0; row < 4; ++row) {
      const int y = int(random.integer(0, kSide - 1));
      for_each_covered(*setup, {0, y, kSide, y + 1}, [&](const Coverage& pixel) {
        const double exact = plane_at(pixel.x + 0.5, pixel.y + 0.5);
        errors.add(std::abs(double(depth(*setup, pixel)) - exact) / exact * 0x1p24);
      });
    }
  }
  return errors.outcome("samples are wrong by more than 8 u");
}

// 64 triangles whose farthest edge goes through pixel centres, and a wall that is as far away as
// that edge, or farther by one to three rounding errors, so that rounding may put the edge behind
// the wall. Either answer is within the error bound, but all engines must give the same one. The
// reference applies the depth formulas pixel by pixel, without boxes, blocks, tiles or an order of
// draws.
Outcome measure_tie_error(const TestedEngine& engine) {
  Random random(257);
  std::int64_t wrong = 0, all = 0;
  for (int i = 0; i < 64; ++i) {
    const float far = float(random.between(0.3, 0.9)), near = float(random.between(0.01, 0.29));
    const float wall = far * (1 + float(i % 4) * 0x1p-23f);
    const double row = 8 * double(random.integer(0, 8)) + 0.5;
    const ScreenTriangle edge{screen_vertex(-40.5, row, far), screen_vertex(300.5, row, far),
                              screen_vertex(double(random.integer(0, 128)), 400, near)};
    const ScreenTriangle flat{screen_vertex(-200, -200, wall), screen_vertex(800, -200, wall),
                              screen_vertex(-200, 800, wall)};
    for (const auto& triangles : {std::vector{edge, flat}, {flat, edge}}) {
      const Image<int> right = z_buffered(triangles, 128, {});
      for (const DrawGrouping draws : {DrawGrouping::kOne, DrawGrouping::kEach}) {
        const Image<int> found = visible_triangles(engine, triangles, 128, draws);
        for (std::size_t p = 0; p < right.pixels.size(); ++p) {
          wrong += found.pixels[p] != right.pixels[p];
        }
        all += std::int64_t(right.pixels.size());
      }
    }
  }
  return must_be_zero(
      double(wrong),
      fmt::format("in {} of {} pixels the order of equal depths is wrong", wrong, all));
}

// Two rectangles whose computed depths are the same, although the exact depth of the second one is
// nearer. The first one must stay visible, as it does in an engine that does not test bounding
// boxes.
Outcome measure_pane_order_error(const TestedEngine& engine) {
  PixelChanges all;
  for (int i = 0; i + 1 < 200; ++i) {
    std::vector<FarPane> panes;
    for (const int k : {i, i + 1}) {
      panes.push_back({1e6f + float(k) * 0.0625f,
                       1e-5,
                       5e-4 + k * 0.0625 * 1e-5 - (k - i) * 2e-8,
                       {k == i ? 1.0f : 0.0f, 0, 1}});
    }
    const PixelChanges found = compare_with_added_triangle(engine, panes);
    all.changed += found.changed;
    all.shown += found.shown;
  }
  if (all.shown == 0) return must_be_zero(HUGE_VAL, "no pane was drawn");
  return wrong_count_outcome(
      int(all.changed), int(all.shown),
      "pixels of panes show the pane that was drawn second instead of the first");
}

// Triangles of one plane in a picture of 256 x 256 pixels; compares the depths that the engine
// stores with those of the plane.
Outcome measure_drawn_error(const TestedEngine& engine) {
  Random random(157);
  std::vector<ScreenTriangle> triangles;
  for (int i = 0; i < 60; ++i) {
    ScreenTriangle t;
    const std::int64_t left = random.integer(0, 200), top = random.integer(0, 200);
    for (ScreenVertex& v : t) {
      const bool small = i % 2 == 0;
      const double x = double(small ? left + random.integer(0, 60) : random.integer(-64, 320));
      const double y = double(small ? top + random.integer(0, 60) : random.integer(-64, 320));
      v = screen_vertex(x, y, float(plane_at(x, y)));
    }
    triangles.push_back(t);
  }
  const Outcome depths =
      measure_depth_error(engine, triangles, 256, 8, [](int x, int y, std::size_t) {
        return static_cast<long double>(plane_at(x + 0.5, y + 0.5));
      });
  const Outcome order = worse_of(measure_tie_error(engine), measure_pane_order_error(engine));
  return order.passes() ? depths : order;
}

}  // namespace c57

ExtremeCase c57_coplanar() {
  using namespace c57;
  return {
      .id = "C-57",
      .name = "One plane, other triangles",
      .construction =
          "300 random triangles of the plane 1/4 + x/2^14 + y/2^15, with vertices on whole pixels "
          "of 4096 x 4096, where depth is exact",
      .stage = "interpolate",
      .right_answer =
          "depth differs from the plane by at most 8 u (raster/interpolate.h), so that of two "
          "triangles differs by at most 16 u; with equal depths the first one stays",
      .unit = "2^-24 relative",
      .oracle = Oracle::kRational,
      .ours = {"weights of differences from the nearest vertex",
               [] { return measure_error(pipeline_depth); }},
      .naive = {"d = A x + B y + C in float", [] { return measure_error(naive::plane_depth); }},
      .mutants = {{"depth from gradients, starting at the corner of the triangle's box",
                   [] { return measure_error(naive::depth_from_corner); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
