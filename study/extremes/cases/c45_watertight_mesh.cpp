#include "study/extremes/common/coverage.h"
#include "study/extremes/common/drawn_coverage.h"
#include "study/extremes/common/ray_cast.h"

#include <glassbox/mesh/builtin/teapot.h>
#include "study/extremes/common/extreme_case.h"
#include "study/naive/coverage.h"

#include <glassbox/base/random.h>

namespace glassbox::study {
namespace c45 {

constexpr int kSide = 1024;

// Slanted triangles of 34,000 px, side by side across the picture: float has too few bits for edge
// functions of that length.
std::vector<ScreenTriangle> long_triangles() {
  constexpr std::size_t kStrips = 16;
  Random random(46);
  std::vector<ScreenVertex> left, right;
  for (std::size_t i = 0; i <= kStrips; ++i) {
    const double y = -600 + double(i) * 1700 / kStrips;  // y of the strip at x = 0
    left.push_back(screen_vertex(-15000, y - 7500 + random.between(-9, 9)));
    right.push_back(screen_vertex(16000, y + 8000 + random.between(-9, 9)));
  }
  std::vector<ScreenTriangle> all;
  for (std::size_t i = 0; i < kStrips; ++i) {
    all.push_back({left[i], right[i], right[i + 1]});
    all.push_back({left[i], right[i + 1], left[i + 1]});
  }
  return all;
}

const std::vector<std::vector<ScreenTriangle>>& meshes() {
  static const std::vector<std::vector<ScreenTriangle>> all{
      jittered_grid(500, 500, kSide, kSide, 0.2, 45), long_triangles()};
  return all;
}

Outcome measure_error(const CoverageFunction& covers) {
  Watertightness found;
  for (const auto& mesh : meshes()) found.add(times_covered(covers, mesh, kSide, kSide));
  return found.outcome();
}

Outcome with(const naive::CoverageParts& parts) {
  return measure_error(naive::covers_with(parts));
}

Outcome measure_drawn_error(const TestedEngine& engine) {
  static const CoverageReference grid(meshes()[0], kSide), slanted(meshes()[1], kSide);
  static const RayCastReference teapot(
      make_ray_scene(make_teapot(12), camera_at({3, 4, 7}, {-3, -2.8, -7}), 192, 192));
  return worse_of(teapot.measure_error(engine),
                  worse_of(slanted.measure_error(engine), grid.measure_error(engine)));
}

}  // namespace c45

ExtremeCase c45_watertight_mesh() {
  using namespace c45;
  return {
      .id = "C-45",
      .name = "Watertight mesh",
      .construction =
          "a grid of 500 x 500 quads over 1024 x 1024 px, inner vertices moved by up to 0.2 of a "
          "cell; 32 slanted triangles 34,000 px long; drawn, a "
          "teapot of 9,000 triangles as well",
      .stage = "coverage",
      .right_answer =
          "every pixel is covered exactly once, because edge functions are integers and each edge "
          "belongs to one triangle",
      .unit = "pixels",
      .oracle = Oracle::kInteger,
      .ours = {"integer edge functions, top-left rule",
               [] { return measure_error(pipeline_covers); }},
      .naive = {"float cross products, >= 0", [] { return measure_error(naive::float_covers); }},
      .mutants = {{"float edge functions, relative to each edge's first vertex",
                   [] { return with({.inside = naive::float_difference_inside}); }},
                  {"the tie rule is missing: no triangle owns an edge",
                   [] { return with({.owns = naive::owns_none}); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
