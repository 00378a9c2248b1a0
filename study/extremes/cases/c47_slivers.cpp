#include <glassbox/base/random.h>
#include <glassbox/raster/coverage.h>
#include <glassbox/raster/interpolate.h>

#include "study/extremes/common/coverage.h"
#include "study/extremes/common/drawn_coverage.h"
#include "study/extremes/common/extreme_case.h"
#include "study/naive/coverage.h"

namespace glassbox::study {
namespace c47 {

constexpr double kLength = 4000;

// A triangle with a width of 2^-k px at one end and 0 at the other, in a random direction.
ScreenTriangle sliver(int k, Random& random) {
  const double x = random.between(0, 100), y = random.between(0, 100);
  const double slope = random.between(0.05, 0.95);
  return {screen_vertex(x, y, 0.25f), screen_vertex(x + kLength, y + kLength * slope, 0.75f),
          screen_vertex(x, y + std::ldexp(1.0, -k), 0.5f)};
}

// Tests only pixels whose centres can be inside the slivers: in each column, those beside the long
// edge.
Outcome measure_error(const CoverageFunction& covers) {
  Random random(47);
  CoverageFaults faults;
  std::int64_t covered = 0;
  for (int k = 8; k <= 20; ++k) {
    for (int i = 0; i < 4; ++i) {
      const ScreenTriangle t = sliver(k, random);
      const double slope = double(t[1].position.y - t[0].position.y) / kLength;
      for (int x = int(t[0].position.x); x < int(t[1].position.x); x += 1) {
        const int y = int(double(t[0].position.y) + (x + 0.5 - double(t[0].position.x)) * slope);
        compare_coverage(covers, t, {x, y - 1, x + 1, y + 2}, faults);
        covers(t, {x, y - 1, x + 1, y + 2}, [&](int, int) { ++covered; });
      }
    }
  }
  Outcome outcome = faults.outcome();
  outcome.summary += fmt::format("; {} covered", covered);
  return outcome;
}

// For the pipeline, also tests that the weights of the fragments are finite and between 0 and 1.
Outcome measure_our_error() {
  Outcome outcome = measure_error(pipeline_covers);
  Random random(47);
  for (int k = 8; k <= 20; ++k) {
    const auto setup = setup_triangle(sliver(k, random));
    if (!setup) continue;
    for_each_covered(*setup, {0, 0, 4200, 4200}, [&](const Coverage& pixel) {
      const Fragment fragment = interpolate(*setup, pixel);
      for (const float weight : fragment.weights) {
        if (!(weight >= 0.0f && weight <= 1.00001f)) outcome.error = INFINITY;
      }
    });
  }
  return outcome;
}

// Slivers a quarter as long as in measure_error, and 1/256 to 4/256 px wide.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const CoverageReference slivers(
      [] {
        Random random(147);
        std::vector<ScreenTriangle> all;
        for (int i = 0; i < 200; ++i) {
          const double x = random.between(0, 200), y = random.between(0, 900);
          const double dx = random.between(400, 1000), dy = random.between(-900, 900);
          const double width = double(random.integer(1, 4)) / 256;
          all.push_back(
              {screen_vertex(x, y), screen_vertex(x + dx, y + dy), screen_vertex(x, y + width)});
        }
        return all;
      }(),
      1024);
  return slivers.measure_error(engine);
}

}  // namespace c47

ExtremeCase c47_slivers() {
  using namespace c47;
  return {
      .id = "C-47",
      .name = "Slivers",
      .construction = "triangles 4,000 px long and 2^-8 to 2^-20 px wide, in four directions each",
      .stage = "coverage",
      .right_answer =
          "exactly the pixels of the snapped triangle are covered, and none if its area is zero; "
          "weights are in [0, 1], because 1/area is computed from an integer of at least 1",
      .unit = "pixels",
      .oracle = Oracle::kInteger,
      .ours = {"integer edge functions", measure_our_error},
      .naive = {"float cross products, >= 0", [] { return measure_error(naive::float_covers); }},
      .mutants = {{"float edge functions, relative to each edge's first vertex",
                   [] {
                     return measure_error(
                         naive::covers_with({.inside = naive::float_difference_inside}));
                   }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
