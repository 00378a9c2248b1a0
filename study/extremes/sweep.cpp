#include "study/extremes/sweep.h"

#include <algorithm>

namespace glassbox::study {

#define ENTRY(name) Sweep name();
// has ENTRY(s1_near_far) and so on, one for each file in sweeps/ (CMakeLists.txt)
#include <sweeps.inc>
#undef ENTRY

const std::vector<Sweep>& sweeps() {
  static const std::vector<Sweep> all{
#define ENTRY(name) name(),
#include <sweeps.inc>
#undef ENTRY
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
  if (beyond != series.points.end()) series.failure_parameter = beyond->parameter;
  return series;
}

}  // namespace glassbox::study
