#include "study/extremes/cases/clip_case.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/ray_cast.h"

namespace glassbox::study {
namespace c36 {

Outcome measure_error(ClipFunction clips) {
  const auto planes = frustum_planes();
  // The plane x + y + z' = 0 (with z' = 2z - 1) cuts the box of NDC in a regular hexagon. This
  // triangle lies in it and cuts off three of the hexagon's corners, so the outline has nine
  // vertices.
  constexpr float r = 1.875f;
  const ClipTriangle nine =
      clip_corners({-r, r, 0.5f, 1}, {0, -r, (r + 1) / 2, 1}, {r, 0, (1 - r) / 2, 1});
  const ClipTriangle nine_turned =
      clip_corners(nine[1].position, nine[2].position, nine[0].position);
  const ClipTriangle screen =
      clip_corners({-64, -64, 0.5f, 1}, {192, -64, 0.5f, 1}, {-64, 192, 0.5f, 1});
  WorstError worst;
  for (const auto& [t, bound] :
       {// 6 planes round the crossings, by u per coordinate below 2; the perimeter is below 8
        std::pair{nine, 6 * 2 * 8 * 0x1p-24},
        {nine_turned, 6 * 2 * 8 * 0x1p-24},
        // The whole screen, from coordinates with few bits: twice the area is 8, without rounding
        // errors.
        {screen, 0.0}}) {
    const Outline outline = clips(t, planes);
    worst.add(area_error(outline, t, planes), bound, fmt::format("{} vertices", outline.size()));
  }
  return worst.outcome();
}

Outline array_of_eight(const ClipTriangle& t, std::span<const ClipPlane> planes) {
  return naive::clip({.capacity = 8}, t, planes);
}
Outline five_planes(const ClipTriangle& t, std::span<const ClipPlane> planes) {
  return pipeline_clips(t, planes.first(5));
}

// Triangles that extend beyond the frustum on all sides.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<RayCastReference> pictures = [] {
    Random random(836);
    std::vector<RayCastReference> all;
    for (int i = 0; i < 40; ++i) {
      EyeTriangle t;
      for (Point<Eye>& p : t) {
        p = {float(random.between(-30, 30)), float(random.between(-30, 30)),
             float(random.between(-30, 20))};
      }
      all.emplace_back(make_ray_scene({t}, PerspectiveLens{1.2, 0.5, 8.0}, 64));
    }
    return all;
  }();
  return worst_of(pictures, engine);
}

}  // namespace c36

ExtremeCase c36_all_six_planes() {
  using namespace c36;
  return {
      .id = "C-36",
      .name = "All six planes cut",
      .construction =
          "a triangle across the frustum's diagonal that gets nine corners, and one that contains "
          "the whole screen",
      .stage = "clip",
      .right_answer =
          "the clipped polygon has the rational area; it may have three plus six vertices "
          "(Sutherland and Hodgman 1974)",
      .unit = "twice NDC area",
      .oracle = Oracle::kRational,
      .ours = {"clip_triangle", [] { return measure_error(pipeline_clips); }},
      .naive = {"the polygon has room for 8 vertices only",
                [] { return measure_error(array_of_eight); }},
      .mutants = {{"the last plane is forgotten", [] { return measure_error(five_planes); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
