#include "study/extremes/common/coverage.h"
#include "study/extremes/common/drawn_coverage.h"
#include "study/extremes/common/extreme_case.h"
#include "study/naive/coverage.h"

#include <glassbox/base/random.h>

namespace glassbox::study {
namespace c50 {

// Large triangles with random snapped vertices, tested only beside points on their edges: whole
// pictures of this size would need too much memory.
Outcome measure_error(const CoverageFunction& covers) {
  Random random(50);
  CoverageFaults faults;
  for (const int width : {7680, 32767}) {
    for (int i = 0; i < 4000; ++i) {
      SnappedTriangle t;
      for (SnappedVertex& v : t) {
        v = {std::int32_t(random.integer(0, std::int64_t(width) * 256)),
             std::int32_t(random.integer(0, std::int64_t(width) * 256))};
      }
      const ScreenTriangle triangle = screen_triangle(t);
      for (int sample = 0; sample < 4; ++sample) {
        const double share = random.unit();
        const int x = int(std::floor((t[0].x + share * (t[1].x - t[0].x)) / 256));
        const int y = int(std::floor((t[0].y + share * (t[1].y - t[0].y)) / 256));
        compare_coverage(covers, triangle, {x - 1, y - 1, x + 2, y + 2}, faults);
      }
    }
  }
  return faults.outcome();
}

// A picture 4,096 px wide, where edge functions need 40 bits.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const CoverageReference large(
      [] {
        Random random(150);
        std::vector<ScreenTriangle> all;
        const auto anywhere = [&] {
          const double x = double(random.integer(-4096 * 256, 8192 * 256)) / 256;
          return screen_vertex(x, double(random.integer(-4096 * 256, 8192 * 256)) / 256);
        };
        // These triangles are as narrow as small triangles, but so tall that their edge functions
        // do not fit in 32 bits.
        for (int i = 0; i < 6; ++i) {
          const double x = 600 * i, width = double(random.integer(40, 63));
          all.push_back({screen_vertex(x, -20), screen_vertex(x + width, 4000 + x / 8),
                         screen_vertex(x + width / 2, 4100)});
          all.push_back({screen_vertex(x + 100, -20), screen_vertex(x + 100 + width, 30),
                         screen_vertex(x + 100, 4100)});
        }
        for (int i = 0; i < 5; ++i) {
          all.push_back({anywhere(), anywhere(), anywhere()});
        }
        return all;
      }(),
      4096);
  return large.measure_error(engine);
}

}  // namespace c50

ExtremeCase c50_large_viewports() {
  using namespace c50;
  return {
      .id = "C-50",
      .name = "8 K and 32 K viewports",
      .construction =
          "4,000 random triangles each over 7,680 and 32,767 px, tested at 3 x 3 pixels around "
          "four places along an edge",
      .stage = "coverage",
      .right_answer = "the coverage is exact, because edge functions need at most 52 of 63 bits",
      .unit = "pixels",
      .oracle = Oracle::kInteger,
      .ours = {"64-bit edge functions", [] { return measure_error(pipeline_covers); }},
      .naive = {"float cross products, >= 0", [] { return measure_error(naive::float_covers); }},
      .mutants = {{"32-bit edge functions",
                   [] {
                     return measure_error(naive::covers_with({.inside = naive::int32_inside}));
                   }},
                  {"float edge functions, relative to each edge's first vertex",
                   [] {
                     return measure_error(
                         naive::covers_with({.inside = naive::float_difference_inside}));
                   }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
