#include "study/extremes/common/depth.h"
#include "study/extremes/common/extreme_case.h"
#include "study/naive/depth.h"

#include <glassbox/base/random.h>

namespace glassbox::study {
namespace c60 {

// A triangle that is a few 1/256 px wide and 2000 px long, from the near plane to the far plane:
// its normal is at an angle of 89.999 degrees or more to the line of sight.
ScreenTriangle sliver(Random& random) {
  const auto lattice = [&](double low, double high) {
    return std::floor(random.between(low, high) * 256) / 256;
  };
  const double x = lattice(0, 10), y = lattice(0, 10), dy = lattice(200, 1800);
  const double width = double(random.integer(1, 4)) / 256;
  return {screen_vertex(x, y, 0), screen_vertex(x + 2000, y + dy, 1),
          screen_vertex(x + width, y - width, 1)};
}

Outcome measure_error(const DepthAt& depth) {
  Random random(60);
  ErrorsAboveBound errors(8);
  for (int i = 0; i < 30; ++i) {
    const auto setup = setup_triangle(sliver(random));
    if (!setup) continue;
    for_each_covered(*setup, {0, 0, 2100, 2100}, [&](const Coverage& pixel) {
      const auto found = static_cast<long double>(depth(*setup, pixel));
      const long double exact = exact_depth(*setup, pixel);
      errors.add(exact == 0 ? 0 : double(std::abs(found - exact) / exact) * 0x1p24);
    });
  }
  return errors.outcome("pixels are wrong by more than 8 u");
}

// Slivers of this kind, a quarter as long, in separate rows; only a few are drawn together, so that
// none hides another.
Outcome measure_drawn_error(const TestedEngine& engine) {
  Random random(160);
  std::vector<ScreenTriangle> triangles;
  for (int i = 0; i < 16; ++i) {
    const double x = double(random.integer(0, 2560)) / 256,
                 y = i * 32 + double(random.integer(0, 256)) / 256;
    const double dy = double(random.integer(256, 28 * 256)) / 256;
    const double width = double(random.integer(1, 4)) / 256;
    triangles.push_back({screen_vertex(x, y, 0), screen_vertex(x + 480, y + dy, 1),
                         screen_vertex(x + width, y - width, 1)});
  }
  return measure_depth_error(engine, triangles, 512, 8, [&](int x, int y, std::size_t triangle) {
    const auto setup = setup_triangle(triangles[triangle]);
    long double depth = 0;
    for_each_covered(*setup, {x, y, x + 1, y + 1},
                     [&](const Coverage& pixel) { depth = exact_depth(*setup, pixel); });
    return depth;
  });
}

}  // namespace c60

ExtremeCase c60_depth_extrapolation() {
  using namespace c60;
  return {
      .id = "C-60",
      .name = "Depth over slivers",
      .construction =
          "30 triangles 2,000 px long and 1/256 to 4/256 px wide, with the depths 0, 1, 1",
      .stage = "interpolate",
      .right_answer =
          "the relative error of depth is at most 8 u (raster/interpolate.h), because weights are "
          "between 0 and 1 and depth stays between that of the vertices",
      .unit = "2^-24 relative",
      .oracle = Oracle::kRational,
      .ours = {"barycentric weights from integers", [] { return measure_error(pipeline_depth); }},
      .naive = {"depth from gradients, starting at the corner of the triangle's box",
                [] { return measure_error(naive::depth_from_corner); }},
      .mutants = {{"d = A x + B y + C in float", [] { return measure_error(naive::plane_depth); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
