#include <algorithm>
#include <cmath>

#include <glassbox/base/rounding.h>

#include "study/extremes/common/depth.h"
#include "study/extremes/sweep.h"

namespace glassbox::study {

namespace s1 {

constexpr double kDistance = 0.5;  // a fraction of the far plane's distance, which is 1

struct Format {
  const char* name;
  DepthFormat format;
  DepthPath::Detour detour;
  // The difference of two neighbouring codes in depth; 0 for reversed float, where it shrinks with
  // depth.
  double step;
};

// The bound for the relative separation, with the unit roundoff u. The float pipeline may have an
// error of 3 u in each of two standard depths near 1 (product, sum, quotient). With reversed depth
// it may have a relative error of 4 u in all (C-56).
double bound_of(const Format& format, double near) {
  const double u = double(unit_roundoff<float>);
  if (format.step == 0) return 4 * u;
  return standard_separation(kDistance, near, 1, format.step + 6 * u);
}

SweepSeries series_of(const Format& format) {
  SweepSeries series{format.name, format.step == 0};
  for (int decade = 1; decade <= 12; ++decade) {
    for (const double part : {1.0, std::sqrt(10.0)}) {
      const double ratio = std::pow(10.0, decade) * part;
      if (ratio > 1e12) continue;
      const DepthPath path{format.format, 1 / ratio, 1, format.detour};
      const double bound = bound_of(format, path.near);
      const double confused = coarsest_confused(path, kDistance, std::min(bound, 0.5));
      series.points.push_back(
          {ratio, confused, std::isfinite(bound) ? std::optional(bound) : std::nullopt});
    }
  }
  return with_limit(std::move(series), 0.1);
}

std::vector<SweepSeries> near_far_series() {
  std::vector<SweepSeries> all;
  for (const Format& format :
       {Format{"float reversed", DepthFormat::kFloat32Reversed, DepthPath::kNone, 0},
        {"float", DepthFormat::kFloat32, DepthPath::kNone, 0x1p-24},
        {"float, reversed by way of [-1, 1]", DepthFormat::kFloat32Reversed, DepthPath::kThroughGl,
         0x1p-24},
        {"24 bits", DepthFormat::kUnorm24, DepthPath::kNone, 0x1p-24},
        {"16 bits", DepthFormat::kUnorm16, DepthPath::kNone, 1 / 65535.0}}) {
    all.push_back(series_of(format));
  }
  return all;
}

}  // namespace s1

Sweep s1_near_far() {
  using namespace s1;
  return {
      .name = "near-far",
      .title = "Far plane over near plane",
      .question =
          "How large may this ratio be before a depth format confuses surfaces that are clearly "
          "apart?",
      .axis = "far plane over near plane",
      .error =
          "largest relative separation of surfaces that are confused, half way to the far plane",
      .reference = "the order of the distances themselves",
      .bound =
          "the smallest distance that is resolved is s z/(1 - s z) with s = (step + 6 u)(1/n - "
          "1/f), and 4 u for reversed float (B.3)",
      .tolerance = "surfaces that are a tenth of the distance apart are confused",
      .series = near_far_series};
}

}  // namespace glassbox::study
