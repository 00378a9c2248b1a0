#include "study/extremes/common/coverage.h"
#include "study/extremes/common/drawn_coverage.h"
#include "study/extremes/common/extreme_case.h"
#include "study/naive/coverage.h"

#include <glassbox/base/random.h>

namespace glassbox::study {
namespace c48 {

ScreenTriangle random_triangle(Random& random) {
  ScreenTriangle t;
  for (ScreenVertex& v : t) {
    const double x = random.between(-9, 9), y = random.between(-9, 9);
    v = screen_vertex(x, y);
  }
  return t;
}

Outcome measure_error(const CoverageFunction& covers) {
  Random random(48);
  CoverageFaults faults;
  for (int i = 0; i < 4000; ++i) {
    compare_coverage(covers, random_triangle(random), {-8, -8, 8, 8}, faults);
  }
  return faults.outcome();
}

// Shifts each covered pixel as truncation to an integer does if a triangle extends to the left of
// column 0 or above row 0: both -0.3 and 0.3 become column 0.
void truncating_covers(const ScreenTriangle& t, const PixelRect& window,
                       const PixelVisitor& visit) {
  naive::covers_with({}, t, window, [&](int x, int y) {
    const auto truncated = [](int i) { return int(float(i) + 0.5f); };
    visit(truncated(x), truncated(y));
  });
}

Outcome measure_naive_error() {
  // Pixels outside the window are lost, as they would be on a screen.
  return measure_error(
      [](const ScreenTriangle& t, const PixelRect& window, const PixelVisitor& visit) {
        truncating_covers(t, window, [&](int x, int y) {
          if (x >= window.x0 && x < window.x1 && y >= window.y0 && y < window.y1) visit(x, y);
        });
      });
}

// Triangles across the left and the upper edge of a picture.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const CoverageReference across(
      [] {
        Random random(148);
        std::vector<ScreenTriangle> all;
        for (int i = 0; i < 64; ++i) {
          ScreenTriangle t = random_triangle(random);
          for (ScreenVertex& v : t) (i % 2 == 0 ? v.position.x : v.position.y) += float(i / 2 * 16);
          all.push_back(t);
        }
        return all;
      }(),
      512);
  return across.measure_error(engine);
}

}  // namespace c48

ExtremeCase c48_negative_coordinates() {
  using namespace c48;
  return {
      .id = "C-48",
      .name = "Negative coordinates",
      .construction =
          "4,000 random triangles across both axes of the screen, on columns and rows -8 to 7",
      .stage = "snap, coverage",
      .right_answer =
          "all positions are rounded down, because shifts of integers round down, so column -1 is "
          "a column like any other",
      .unit = "pixels",
      .oracle = Oracle::kInteger,
      .ours = {"floor", [] { return measure_error(pipeline_covers); }},
      .naive = {"(int) of the pixel's position", measure_naive_error},
      .mutants = {{"the snap truncates in place of rounding by floor",
                   [] {
                     return measure_error(naive::covers_with({.snap = naive::snap_truncating}));
                   }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
