#include <glassbox/base/rounding.h>
#include <glassbox/base/trig.h>

#include "study/extremes/common/depth.h"
#include "study/extremes/common/extreme_case.h"

namespace glassbox::study {
namespace c59 {

constexpr int kSide = 256;
constexpr double kDepthOfView = 1024;  // the depth range 0 .. 1, in px

double crossing_at(double y) {
  return 100 + 0.25 * y;
}

// Two rectangles over the whole picture. Their depths change by +-slope per pixel and are equal at
// x = crossing_at(y). The depths are around 0.6, which is not a special value in any depth format.
std::vector<ScreenTriangle> crossing(double slope) {
  std::vector<ScreenTriangle> all;
  for (const double sign : {1.0, -1.0}) {
    const auto v = [&](double x, double y) {
      return screen_vertex(x, y, float(0.6 + sign * slope * (x - crossing_at(y))));
    };
    all.push_back({v(0, 0), v(kSide, 0), v(kSide, kSide)});
    all.push_back({v(0, 0), v(kSide, kSide), v(0, kSide)});
  }
  return all;
}

using Draws = std::function<Image<int>(const std::vector<ScreenTriangle>&)>;

Outcome measure_error(const Draws& draws) {
  WorstError worst;
  for (const double degrees : {90.0, 1.0, 0.01}) {
    const double slope = tan_half_degrees(degrees) / kDepthOfView;
    const Image<int> seen = draws(crossing(slope));
    // Each of the two depths has an error of up to 8 u from interpolation and u from its vertices
    // (u is the unit roundoff) of numbers up to 0.75. Divided by the difference of the slopes, 2 *
    // slope, this is a distance in px. Half a pixel is added because each pixel has a single
    // answer.
    const double bound = 2 * 9 * double(unit_roundoff<float>) * 0.75 / (2 * slope) + 0.5;
    double farthest = 0;
    for (int y = 0; y < seen.height; ++y) {
      for (int x = 0; x < seen.width; ++x) {
        const bool first = seen.at(x, y) <= 2;
        const double beyond = x + 0.5 - crossing_at(y + 0.5);
        if (first != (beyond < 0)) farthest = std::max(farthest, std::abs(beyond));
      }
    }
    worst.add(farthest, bound, fmt::format("{:.3g} px off at {} degrees", farthest, degrees));
  }
  return worst.outcome();
}

// Draws first one rectangle, then the other over it: one rectangle hides the other everywhere.
Image<int> painted(const std::vector<ScreenTriangle>& triangles) {
  return z_buffered(triangles, kSide,
                    {.passes = [](std::uint32_t, std::uint32_t) { return true; }});
}

Image<int> in_16_bits(const std::vector<ScreenTriangle>& triangles) {
  return z_buffered(triangles, kSide, {.format = DepthFormat::kUnorm16});
}

Outcome measure_drawn_error(const TestedEngine& engine) {
  return measure_error([&](const std::vector<ScreenTriangle>& all) {
    return visible_triangles(engine, all, kSide);
  });
}

}  // namespace c59

ExtremeCase c59_interpenetration() {
  using namespace c59;
  return {
      .id = "C-59",
      .name = "Rectangles through each other",
      .construction =
          "two rectangles over 256 x 256 px that cross at 90, 1 and 0.01 degrees along a slanted "
          "line",
      .stage = "depth test",
      .right_answer =
          "the crossing is at the right place, to 18 u d/|difference of the slopes| and half a "
          "pixel",
      .unit = "px",
      .oracle = Oracle::kAnalytic,
      .ours = {"the staged reference, float depth",
               [] { return measure_drawn_error(tested_engines()[0]); }},
      .naive = {"painter's algorithm", [] { return measure_error(painted); }},
      .mutants = {{"depth has only 16 bits", [] { return measure_error(in_16_bits); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
