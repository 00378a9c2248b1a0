#include <cmath>

#include "study/extremes/common/coverage.h"
#include "study/extremes/sweep.h"
#include "study/naive/coverage.h"

#include <glassbox/base/random.h>

namespace glassbox::study {

namespace s5 {

constexpr double kLength = 4000;

// The fraction of wrong answers among the pixels beside the long edge of slivers.
double share_wrong(const CoverageFunction& covers, double width) {
  Random random(4);
  CoverageFaults faults;
  for (int i = 0; i < 12; ++i) {
    const double x = random.between(0, 100), y = random.between(0, 100);
    const double slope = random.between(0.05, 0.95);
    const ScreenTriangle t{screen_vertex(x, y), screen_vertex(x + kLength, y + kLength * slope),
                           screen_vertex(x, y + width)};
    for (int column = int(x) + 1; column < int(x + kLength); ++column) {
      const int row = int(std::floor(y + (column + 0.5 - x) * slope));
      compare_coverage(covers, t, {column, row, column + 1, row + 1}, faults);
    }
  }
  return faults.share_wrong();
}

SweepSeries series_of(const char* name, const CoverageFunction& covers, bool ours) {
  SweepSeries series{name, ours};
  for (int bits = 0; bits <= 20; ++bits) {
    const double width = std::ldexp(1.0, -bits);
    series.points.push_back(
        {width, share_wrong(covers, width), ours ? std::optional(0.0) : std::nullopt});
  }
  return with_limit(std::move(series), 0);
}

std::vector<SweepSeries> sliver_series() {
  return {series_of("64-bit integers", pipeline_covers, true),
          series_of("float differences of snapped vertices",
                    naive::covers_with({.inside = naive::float_difference_inside}), false),
          series_of("float, not snapped", naive::float_covers, false)};
}

}  // namespace s5

Sweep s5_sliver() {
  using namespace s5;
  return {
      .name = "sliver",
      .title = "Width of a sliver",
      .question = "How thin may a triangle 4,000 px long be before pixels are decided wrongly?",
      .axis = "width",
      .axis_unit = "px",
      .error = "fraction of the pixels along the edge that are wrong",
      .reference = "the snapped triangle in 128 bits",
      .bound =
          "no pixel is wrong, because edge functions are integers; with float there is no bound",
      .tolerance = "any wrong pixel",
      .series = sliver_series};
}

}  // namespace glassbox::study
