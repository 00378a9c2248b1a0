#include "study/extremes/kit/coverage.h"
#include "study/extremes/kit/extreme_case.h"
#include "study/extremes/kit/screen_scene.h"
#include "study/naive/coverage.h"

#include <glassbox/base/random.h>

namespace glassbox::study {
namespace c45 {

constexpr int kSide = 1024;

// Triangles 34,000 px long, slanted and side by side over the picture: float has too few bits for edge functions of that
// length.
std::vector<ScreenTriangle> long_triangles() {
  constexpr std::size_t kStrips = 16;
  Random random(46);
  std::vector<ScreenVertex> left, right;
  for (std::size_t i = 0; i <= kStrips; ++i) {
    const double y = -600 + double(i) * 1700 / kStrips;  // where the strip meets x = 0
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

using Covered = std::function<Image<int>(const std::vector<ScreenTriangle>&)>;

Outcome judge(const Covered& covered, const char* by = "") {
  Watertightness found;
  for (const auto& mesh : meshes()) found.add(covered(mesh));
  Outcome outcome = found.outcome();
  outcome.seen += by;
  return outcome;
}

Outcome judge(const Covers& covers) {
  return judge([&](const std::vector<ScreenTriangle>& mesh) {
    return times_covered(covers, mesh, kSide, kSide);
  });
}

// The stage alone, then whole runs: a gap in the opaque one is a pixel that shows nothing.
Outcome judge_ours() {
  const Outcome stage = judge(Covers(pipeline_covers));
  const Outcome engine = judge(
      [](const std::vector<ScreenTriangle>& mesh) {
        TrianglesDrawn drawn = drawn_by_tile_engine(mesh, kSide, {});
        for (std::size_t i = 0; i < drawn.first.pixels.size(); ++i) {
          if (drawn.first.pixels[i] == 0) drawn.times.pixels[i] = 0;
        }
        return drawn.times;
      },
      ", by the stage and by the tile engine");
  return worse_of(engine, stage);
}

Outcome with(const naive::CoverageParts& parts) {
  return judge(naive::covers_with(parts));
}

}  // namespace c45

ExtremeCase c45_watertight_mesh() {
  using namespace c45;
  return {
      .id = "C-45",
      .name = "Watertight mesh",
      .construction =
          "a grid of 500 x 500 quads over 1024 x 1024 px, inner vertices moved by up to 0.2 of a "
          "cell; 32 slanted triangles 34,000 px long",
      .stage = "coverage",
      .right = "every pixel exactly once: edge functions are integers, and one side owns each edge",
      .unit = "pixels",
      .oracle = Oracle::kInteger,
      .ours = {"integer edge functions, top-left rule", judge_ours},
      .naive = {"float cross products, >= 0", [] { return judge(Covers(naive::float_covers)); }},
      .mutants = {{"float edges: differences from each edge's first vertex",
                   [] { return with({.inside = naive::float_difference_inside}); }},
                  {"the tie rule is missing: nobody owns an edge",
                   [] { return with({.owns = naive::owns_none}); }}},
  };
}

}  // namespace glassbox::study
