#include <glassbox/base/trig.h>
#include <glassbox/pipeline/divide.h>
#include <glassbox/pipeline/viewport.h>

#include "study/extremes/cases/clip_case.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/ray_cast.h"

namespace glassbox::study {
namespace c33 {

View view_1080() {
  View view;
  view.viewport = {0, 0, 1920, 1080};
  view.near = 0.01;
  return view;
}

Outcome measure_error(ClipFunction clips) {
  const View view = view_1080();
  const auto planes = render_planes(view);
  int wrong = 0, vertices = 0;
  for (const float w : {0.5f, 1e-2f, 1e-10f, 1e-38f, 1e-45f, 0.0f, -1e-45f}) {
    for (const Point<Clip>& p : {Point<Clip>{0, 0, 0, w}, Point<Clip>{1, -1, 0, w},
                                 Point<Clip>{1e30f, 1, w / 2, w}, Point<Clip>{w, w, w, w}}) {
      const ClipTriangle t = clip_corners(p, {0.5f, -0.5f, 0.5f, 1}, {-0.5f, 0.5f, 0.5f, 1});
      for (const Point<Clip>& q : clips(t, planes)) {
        const ScreenVertex screen = to_screen(divide(q), view.viewport);
        ++vertices;
        // The size of the guard band plus 4 u of 2^16 (u is the unit roundoff, 2^-24): the rounding
        // errors of the crossing, of the quotient and two of the viewport.
        const double reach = kGuardBandPx + 0x1p-6;
        const bool sound = std::abs(double(screen.position.x) - 960) <= reach &&
                           std::abs(double(screen.position.y) - 540) <= reach &&
                           std::isfinite(screen.inverse_w) && q.w >= float(view.near / 2);
        wrong += !sound;
      }
    }
  }
  return wrong_count_outcome(wrong, vertices,
                             "vertices are outside the guard band, or their w is too small");
}

Outline without_eye_plane(const ClipTriangle& t, std::span<const ClipPlane> planes) {
  std::vector<ClipPlane> others(planes.begin(), planes.end());
  others.erase(others.begin() + 1);
  return pipeline_clips(t, others);
}
Outline without_guard_band(const ClipTriangle& t, std::span<const ClipPlane> planes) {
  return pipeline_clips(t, planes.first(2));
}

// The same corners as in measure_error, in eye space, where the distance along the gaze is w; each
// triangle is in a picture of its own.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<RayCastReference> pictures = [] {
    std::vector<RayCastReference> all;
    for (const float w : {0.5f, 1e-2f, 1e-10f, 1e-38f, 1e-45f, 0.0f, -1e-45f}) {
      for (const auto& [x, y] : {std::array{0.0f, 0.0f}, {1.0f, -1.0f}, {1e6f, 1.0f}, {w, w}}) {
        all.emplace_back(
            make_ray_scene({{Point<Eye>{x, y, -w}, {0.5f, -0.5f, -1}, {-0.5f, 0.5f, -1}}},
                           PerspectiveLens{radians_from_degrees(90), 0.01, 8.0}, 32));
      }
    }
    return all;
  }();
  return worst_of(pictures, engine);
}

}  // namespace c33

ExtremeCase c33_w_towards_zero() {
  using namespace c33;
  return {
      .id = "C-33",
      .name = "w towards zero",
      .construction =
          "triangles that have a corner with w = 0.5 .. 1e-45, 0 or -1e-45, in four places; near "
          "plane 0.01",
      .stage = "clip",
      .right_answer =
          "after clipping w >= near/2 and every vertex is within the guard band, so there is no "
          "infinity, no NaN and no overflow",
      .unit = "vertices",
      .oracle = Oracle::kProperty,
      .ours = {"clip_triangle by render_planes", [] { return measure_error(pipeline_clips); }},
      .naive = {"divide without clipping", [] { return measure_error(naive::nothing); }},
      .mutants = {{"nothing is clipped at the plane of the eye",
                   [] { return measure_error(without_eye_plane); }},
                  {"nothing is clipped at the guard band",
                   [] { return measure_error(without_guard_band); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
