#include "study/extremes/sweeps/sweeps.h"

#include <algorithm>

namespace glassbox::study {

const std::vector<Sweep>& sweeps() {
  static const std::vector<Sweep> all{
      near_far_sweep(), world_offset_sweep(), field_of_view_sweep(), up_angle_sweep(),
      sliver_sweep(),   viewport_sweep(),     nesting_sweep(),       separation_sweep(),
  };
  return all;
}

bool within_bounds(const SweepSeries& series) {
  return std::ranges::all_of(series.points, [](const SweepPoint& point) {
    return !point.bound || point.error <= *point.bound;
  });
}

SweepSeries with_limit(SweepSeries series, double tolerance) {
  const auto beyond = std::ranges::find_if(
      series.points, [&](const SweepPoint& point) { return !(point.error <= tolerance); });
  if (beyond != series.points.end()) series.gives_up = beyond->parameter;
  return series;
}

}  // namespace glassbox::study
