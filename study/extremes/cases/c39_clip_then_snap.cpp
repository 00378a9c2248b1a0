#include <glassbox/base/trig.h>
#include <glassbox/raster/rasterise_polygon.h>

#include "study/extremes/cases/clip_case.h"
#include "study/extremes/common/coverage.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/ray_cast.h"

namespace glassbox::study {
namespace c39 {

constexpr int kSide = 64;

constexpr int kFans = 12, kSlivers = 200;

// Counts how often each pixel is covered by a fan of 200 slivers around a point of the picture. The
// outer corners are 1e5 to 1e7 px away, so all edges from the point cross the border of the guard
// band.
Image<int> times_covered_by_fan(ClipFunction clips, int fan) {
  Random random(739 + std::uint64_t(fan));
  const float hub_x = float(random.between(-0.9, 0.9)), hub_y = float(random.between(-0.9, 0.9));
  const Point<Clip> hub{hub_x, hub_y, 0.5f, 1};
  std::vector<Point<Clip>> rim;
  for (int i = 0; i < kSlivers; ++i) {
    const SinCos turn = sin_cos_degrees(360.0 / kSlivers * (i + random.between(0, 0.9)));
    const double reach = random.between(1e5, 1e7) / (0.5 * kSide);
    const float w = float(random.between(0.5, 2));
    rim.push_back({float(reach * turn.cos) * w, float(reach * turn.sin) * w, 0.5f * w, w});
  }
  const Viewport viewport{0, 0, kSide, kSide};
  const auto planes = guard_band_planes(viewport);
  Image<int> times(kSide, kSide);
  for (std::size_t i = 0; i < rim.size(); ++i) {
    // Every second triangle starts at another corner, so that shared edges are traversed from
    // different ends.
    const Point<Clip>&a = rim[i], &b = rim[(i + 1) % rim.size()];
    const ClipTriangle t = i % 2 == 0 ? clip_corners(hub, a, b) : clip_corners(b, hub, a);
    for_each_covered(clips(t, planes), viewport, {0, 0, kSide, kSide},
                     [&](const Coverage& pixel) { ++times.at(pixel.x, pixel.y); });
  }
  return times;
}

Outcome measure_error(ClipFunction clips) {
  Watertightness all;
  for (int fan = 0; fan < kFans; ++fan) all.add(times_covered_by_fan(clips, fan));
  return all.outcome();
}

std::string picture(ClipFunction clips) {
  return coverage_png(times_covered_by_fan(clips, 0), 6);
}

// Clips to the picture itself instead of the guard band. The two triangles of an edge give it
// different crossings, and snapping moves these differently.
Outline at_the_screen(const ClipTriangle& t, std::span<const ClipPlane>) {
  const auto planes = frustum_planes();
  return naive::clip({}, t, std::span(planes).last(4));
}
Outline asymmetric(const ClipTriangle& t, std::span<const ClipPlane> planes) {
  return naive::clip({}, t, planes);
}

// Two fans of slivers in eye space: every pixel must have one layer, that of the sliver at that
// place.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<RayCastReference> pictures = [] {
    std::vector<RayCastReference> all;
    for (int fan = 0; fan < 2; ++fan) {
      Random random(839 + std::uint64_t(fan));
      const float hub_x = float(random.between(-0.9, 0.9)),
                  hub_y = float(random.between(-0.9, 0.9));
      const Point<Eye> hub{hub_x, hub_y, -1};
      std::vector<Point<Eye>> rim;
      for (int i = 0; i < kSlivers; ++i) {
        const SinCos turn = sin_cos_degrees(360.0 / kSlivers * (i + random.between(0, 0.9)));
        const double reach = random.between(1e5, 1e7) / (0.5 * kSide), w = random.between(0.5, 2);
        rim.push_back({float(reach * turn.cos * w), float(reach * turn.sin * w), float(-w)});
      }
      std::vector<EyeTriangle> slivers;
      for (std::size_t i = 0; i < rim.size(); ++i) {
        const Point<Eye>&a = rim[i], &b = rim[(i + 1) % rim.size()];
        slivers.push_back(i % 2 == 0 ? EyeTriangle{hub, a, b} : EyeTriangle{b, hub, a});
      }
      all.emplace_back(
          make_ray_scene(slivers, PerspectiveLens{radians_from_degrees(90), 0.1, 100.0}, kSide));
    }
    return all;
  }();
  return worst_of(pictures, engine);
}

}  // namespace c39

ExtremeCase c39_clip_then_snap() {
  using namespace c39;
  return {
      .id = "C-39",
      .name = "Clipped, then snapped",
      .construction =
          "12 fans of 200 slivers around a point of a 64 x 64 picture, outer corners 1e5 .. 1e7 px "
          "away",
      .stage = "clip",
      .right_answer = "every pixel is covered exactly once",
      .unit = "pixels",
      .oracle = Oracle::kInteger,
      .ours = {"clip_triangle by the guard band", [] { return measure_error(pipeline_clips); }},
      .naive = {"a + t (b - a), clipped at the picture's edge",
                [] { return measure_error(at_the_screen); }},
      .mutants = {{"crossings at the guard band depend on the direction of the edge",
                   [] { return measure_error(asymmetric); }}},
      .drawn = measure_drawn_error,
      .pictures = {{"ours", [] { return picture(pipeline_clips); }},
                   {"naive", [] { return picture(at_the_screen); }}},
  };
}

}  // namespace glassbox::study
