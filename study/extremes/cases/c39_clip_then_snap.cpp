#include <glassbox/base/trig.h>

#include <fmt/format.h>
#include <vector>

#include "study/extremes/cases/cases.h"
#include "study/extremes/kit/clip_coverage.h"
#include "study/extremes/kit/worst.h"

namespace glassbox::study {
namespace {

constexpr int kSide = 64;

Outcome judge(Clips clips) {
  const Viewport viewport{0, 0, kSide, kSide};
  const auto planes = guard_band_planes(viewport);
  Random random(739);
  int gaps = 0, doubles = 0, samples = 0;
  for (int round = 0; round < 12; ++round) {
    // Slivers around a point of the picture, their outer corners 1e5 .. 1e7 px away: 200 edges cross the guard band.
    const Point<Clip> hub{float(random.between(-0.9, 0.9)), float(random.between(-0.9, 0.9)), 0.5f,
                          1};
    std::vector<Point<Clip>> rim;
    constexpr int kSlivers = 200;
    for (int i = 0; i < kSlivers; ++i) {
      const SinCos turn = sin_cos_degrees(360.0 / kSlivers * (i + random.between(0, 0.9)));
      const double reach = random.between(1e5, 1e7) / (kSide / 2);
      const float w = float(random.between(0.5, 2));
      rim.push_back({float(reach * turn.cos) * w, float(reach * turn.sin) * w, 0.5f * w, w});
    }
    std::vector<int> times(kSide * kSide);
    for (std::size_t i = 0; i < rim.size(); ++i) {
      // Every other one begins elsewhere, so that shared edges are walked from all corners.
      const Point<Clip>&a = rim[i], &b = rim[(i + 1) % rim.size()];
      const ClipTriangle t = i % 2 == 0 ? clip_corners(hub, a, b) : clip_corners(b, hub, a);
      visit_covered(clips(t, planes), viewport, {0, 0, kSide, kSide},
                    [&](int x, int y) { ++times[std::size_t(y * kSide + x)]; });
    }
    for (const int count : times) {
      gaps += count == 0;
      doubles += count > 1;
      ++samples;
    }
  }
  return {double(gaps + doubles), 0, std::nullopt,
          fmt::format("{} gaps, {} doubles of {} samples", gaps, doubles, samples)};
}

// Clipped to the picture itself: both triangles at an edge cut it, each in its own way, and the snap moves it.
Outline at_the_screen(const ClipTriangle& t, std::span<const ClipPlane>) {
  const auto planes = frustum_planes();
  return naive::clip({}, t, std::span(planes).last(4));
}
Outline asymmetric(const ClipTriangle& t, std::span<const ClipPlane> planes) {
  return naive::clip({}, t, planes);
}

}  // namespace

ExtremeCase c39_clip_then_snap() {
  return {
      .id = "C-39",
      .name = "Clipped, then snapped",
      .construction =
          "12 fans of 200 slivers around a point of a 64 x 64 picture, outer corners "
          "1e5 .. 1e7 px away",
      .stage = "clip",
      .right = "every pixel covered exactly once",
      .unit = "pixels",
      .oracle = Oracle::kInteger,
      .ours = {"clip_triangle by the guard band", [] { return judge(pipeline_clips); }},
      .naive = {"a + t (b - a), cut at the picture's edge", [] { return judge(at_the_screen); }},
      .mutants = {{"asymmetric crossings at the guard band", [] { return judge(asymmetric); }}},
  };
}

}  // namespace glassbox::study
