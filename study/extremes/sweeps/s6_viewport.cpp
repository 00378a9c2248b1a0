#include <algorithm>
#include <cmath>

#include "study/extremes/common/coverage.h"
#include "study/extremes/sweep.h"
#include "study/naive/coverage.h"

#include <glassbox/base/random.h>

namespace glassbox::study {

namespace s6 {

double share_wrong(const CoverageFunction& covers, int side) {
  Random random(5);
  CoverageFaults faults;
  const std::int64_t most = std::min<std::int64_t>(std::int64_t(side) * 256, (1 << 23) - 1);
  for (int i = 0; i < 3000; ++i) {
    SnappedTriangle t;
    for (SnappedVertex& v : t) {
      v = {std::int32_t(random.integer(0, most)), std::int32_t(random.integer(0, most))};
    }
    const ScreenTriangle triangle = screen_triangle(t);
    for (int sample = 0; sample < 4; ++sample) {
      const double share = random.unit();
      const int x = int(std::floor((t[0].x + share * (t[1].x - t[0].x)) / 256));
      const int y = int(std::floor((t[0].y + share * (t[1].y - t[0].y)) / 256));
      compare_coverage(covers, triangle, {x, y, x + 1, y + 1}, faults);
    }
  }
  return faults.share_wrong();
}

SweepSeries series_by_size(const char* name, const CoverageFunction& covers, bool ours) {
  SweepSeries series{name, ours};
  for (int side = 1; side <= 32768; side *= 2) {
    series.points.push_back(
        {double(side), share_wrong(covers, side), ours ? std::optional(0.0) : std::nullopt});
  }
  return with_limit(std::move(series), 0);
}

std::vector<SweepSeries> viewport_series() {
  return {
      series_by_size("64-bit integers", pipeline_covers, true),
      series_by_size("32-bit integers", naive::covers_with({.inside = naive::int32_inside}), false),
      series_by_size("float differences of snapped vertices",
                     naive::covers_with({.inside = naive::float_difference_inside}), false),
      series_by_size("float, not snapped", naive::float_covers, false)};
}

}  // namespace s6

Sweep s6_viewport() {
  using namespace s6;
  return {
      .name = "viewport",
      .title = "Size of the picture",
      .question = "How large may a picture be before pixels beside an edge are decided wrongly?",
      .axis = "width and height",
      .axis_unit = "px",
      .error = "fraction of the pixels on random edges that are wrong",
      .reference = "the snapped triangle in 128 bits; large pictures are sampled, not allocated",
      .bound = "no pixel is wrong, because edge functions need at most 52 of 63 bits",
      .tolerance = "any wrong pixel",
      .series = viewport_series};
}

}  // namespace glassbox::study
