#include "study/extremes/common/coverage.h"
#include "study/extremes/common/drawn_coverage.h"
#include "study/extremes/common/extreme_case.h"
#include "study/naive/coverage.h"

#include <glassbox/base/random.h>

namespace glassbox::study {
namespace c51 {

constexpr int kSide = 32;

// A grid with vertices at pixel centres; each triangle has a random winding.
std::vector<ScreenTriangle> mixed_grid() {
  Random random(51);
  std::vector<ScreenTriangle> triangles;
  for (int y = -1; y < kSide + 1; ++y) {
    for (int x = -1; x < kSide + 1; ++x) {
      const auto v = [&](int i, int j) { return screen_vertex(x + i + 0.5, y + j + 0.5); };
      triangles.push_back({v(0, 0), v(1, 0), v(1, 1)});
      triangles.push_back({v(0, 0), v(1, 1), v(0, 1)});
    }
  }
  for (ScreenTriangle& t : triangles) {
    if (random.bits() & 1) std::swap(t[0], t[1]);
  }
  return triangles;
}

Image<int> drawn(const CoverageFunction& covers) {
  return times_covered(covers, mixed_grid(), kSide, kSide);
}

Outcome measure_error(const CoverageFunction& covers) {
  Watertightness found;
  found.add(drawn(covers));
  return found.outcome();
}

const naive::CoverageParts kRuleFirst{.rule_before_orientation = true};

Outcome measure_drawn_error(const TestedEngine& engine) {
  static const CoverageReference grid(mixed_grid(), kSide);
  return grid.measure_error(engine);
}

}  // namespace c51

ExtremeCase c51_winding() {
  using namespace c51;
  return {
      .id = "C-51",
      .name = "Both windings in one surface",
      .construction =
          "a double-sided grid of 34 x 34 quads with vertices at pixel centres, every triangle "
          "wound at random",
      .stage = "setup",
      .right_answer =
          "every pixel is covered exactly once, because all triangles are made clockwise before "
          "their edges are classified",
      .unit = "pixels",
      .oracle = Oracle::kInteger,
      .ours = {"edges are classified after the triangle is made clockwise",
               [] { return measure_error(pipeline_covers); }},
      .naive = {"edges are classified before the triangle is made clockwise",
                [] { return measure_error(naive::covers_with(kRuleFirst)); }},
      .mutants = {{"every triangle owns all pixel centres on its edges",
                   [] { return measure_error(naive::covers_with({.owns = naive::owns_all})); }}},
      .drawn = measure_drawn_error,
      .pictures = {{"naive",
                    [] { return coverage_png(drawn(naive::covers_with(kRuleFirst)), 12); }},
                   {"ours", [] { return coverage_png(drawn(pipeline_covers), 12); }}},
  };
}

}  // namespace glassbox::study
