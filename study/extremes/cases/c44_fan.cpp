#include <cstdlib>

#include <glassbox/base/trig.h>

#include "study/extremes/common/coverage.h"
#include "study/extremes/common/drawn_coverage.h"
#include "study/extremes/common/extreme_case.h"
#include "study/naive/coverage.h"

namespace glassbox::study {
namespace c44 {

constexpr double kCentre = 10.5;
constexpr int kPixel = 10;

// A fan of n triangles around the pixel centre. Every second fan is turned, so that edges have many
// directions, including those of the axes.
std::vector<ScreenTriangle> fan(int n) {
  std::vector<ScreenTriangle> triangles;
  const auto rim = [&](int i) {
    const SinCos angle = sin_cos_degrees(360.0 * (i % n) / n + (n % 2 == 0 ? 0.0 : 7.0));
    return screen_vertex(kCentre + 8 * angle.cos, kCentre + 8 * angle.sin);
  };
  for (int i = 0; i < n; ++i) {
    triangles.push_back({screen_vertex(kCentre, kCentre), rim(i), rim(i + 1)});
  }
  return triangles;
}

Outcome measure_error(const CoverageFunction& covers) {
  int worst = 0, worst_fan = 3, fans = 0, wrong = 0;
  for (int n = 3; n <= 256; ++n) {
    int hits = 0;
    for (const ScreenTriangle& t : fan(n)) {
      covers(t, {kPixel, kPixel, kPixel + 1, kPixel + 1}, [&](int, int) { ++hits; });
    }
    ++fans;
    wrong += hits != 1;
    if (std::abs(hits - 1) > worst) {
      worst = std::abs(hits - 1);
      worst_fan = n;
    }
  }
  if (worst == 0)
    return must_be_zero(0, fmt::format("the centre is covered once in each of {} fans", fans));
  return must_be_zero(worst, fmt::format("{} of {} fans are wrong; the worst one has {} triangles",
                                         wrong, fans, worst_fan));
}

// All fans side by side in one picture.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const CoverageReference fans(
      [] {
        std::vector<ScreenTriangle> triangles;
        for (int n = 3; n <= 256; ++n) {
          for (ScreenTriangle t : fan(n)) {
            for (ScreenVertex& v : t) {
              v.position.x += float((n - 3) % 16 * 32 + 6);
              v.position.y += float((n - 3) / 16 * 32 + 6);
            }
            triangles.push_back(t);
          }
        }
        return triangles;
      }(),
      512);
  return fans.measure_error(engine);
}

}  // namespace c44

ExtremeCase c44_fan() {
  using namespace c44;
  const auto with = [](const naive::CoverageParts& parts) {
    return [parts] { return measure_error(naive::covers_with(parts)); };
  };
  return {
      .id = "C-44",
      .name = "Fan around a pixel centre",
      .construction = "3 to 256 triangles that meet at (10.5, 10.5), radius 8 px",
      .stage = "coverage",
      .right_answer = "the centre belongs to exactly one of them",
      .unit = "hits of the centre, too many or too few",
      .oracle = Oracle::kInteger,
      .ours = {"integer edge functions, top-left rule",
               [] { return measure_error(pipeline_covers); }},
      .naive = {"float cross products, >= 0", [] { return measure_error(naive::float_covers); }},
      .mutants = {{"the tie rule is missing: no triangle owns an edge",
                   with({.owns = naive::owns_none})},
                  {"every triangle owns all pixel centres on its edges",
                   with({.owns = naive::owns_all})},
                  {"horizontal top edges own no pixel centres", with({.owns = naive::left_only})}},
      .drawn = measure_drawn_error,
      .pictures =
          {{"naive",
            [] { return coverage_png(times_covered(naive::float_covers, fan(16), 21, 21), 16); }},
           {"ours",
            [] { return coverage_png(times_covered(pipeline_covers, fan(16), 21, 21), 16); }}},
  };
}

}  // namespace glassbox::study
