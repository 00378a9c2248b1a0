#include <glassbox/base/trig.h>
#include "study/extremes/cases/clip_case.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/ray_cast.h"

namespace glassbox::study {
namespace c32 {

Outcome measure_error(ClipFunction clips) {
  // z - w is -1/2 at all corners, so z = 0 at w = 1/2 and all crossings need few bits: nothing is
  // rounded.
  const std::vector<ClipPlane> near{frustum_planes()[0]};
  const Point<Clip> front{0, 0.25f, 0.5f, 1}, front2{0.5f, 0, 0.5f, 1};
  const Point<Clip> behind{-1, -1, -1.5f, -1}, behind2{1, -1, -1.5f, -1};
  WorstError worst;
  for (const ClipTriangle& t :
       {clip_corners(front, behind, behind2), clip_corners(behind, behind2, front),
        clip_corners(front, front2, behind), clip_corners(behind, front, front2)}) {
    const Outline outline = clips(t, near);
    worst.add(area_error(outline, t, near), 0, std::to_string(outline.size()) + " vertices");
  }
  return worst.outcome();
}

Outline one_triangle(const ClipTriangle& t, std::span<const ClipPlane> planes) {
  Outline outline = pipeline_clips(t, planes);
  if (outline.size() > 3) outline.resize(3);
  return outline;
}
// Exchanges the two ends of the edge in the formula: the crossing is measured from the wrong end.
Outline wrong_end(const ClipTriangle& t, std::span<const ClipPlane> planes) {
  const auto crossing = [](const Point<Clip>& a, float d_a, const Point<Clip>& b, float d_b) {
    return naive::from_first_end(b, d_a, a, d_b);
  };
  return naive::clip({.crossing = crossing}, t, planes);
}

// The triangles of measure_error, each alone in a picture, and versions of them with corners at
// other distances behind the eye.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<RayCastReference> pictures = [] {
    std::vector<RayCastReference> all;
    const Point<Eye> front{0, 0.25f, -1}, front2{0.5f, 0, -1};
    for (const float w : {1.0f, 0.25f, 16.0f}) {
      const Point<Eye> behind{-w, -w, w}, behind2{w, -w, w};
      for (const EyeTriangle& t : {EyeTriangle{front, behind, behind2},
                                   {behind, behind2, front},
                                   {front, front2, behind},
                                   {behind, front, front2}}) {
        all.emplace_back(
            make_ray_scene({t}, PerspectiveLens{radians_from_degrees(90), 0.5, 8.0}, 48));
      }
    }
    return all;
  }();
  return worst_of(pictures, engine);
}

}  // namespace c32

ExtremeCase c32_through_the_eye() {
  using namespace c32;
  return {
      .id = "C-32",
      .name = "A triangle through the eye plane",
      .construction =
          "triangles with w = 1, -1, -1 and 1, 1, -1 at their corners, whose crossings have few "
          "bits",
      .stage = "clip",
      .right_answer = "the clipped polygon has exactly the area of the part in front of the eye",
      .unit = "twice NDC area",
      .oracle = Oracle::kRational,
      .ours = {"clip_triangle", [] { return measure_error(pipeline_clips); }},
      .naive = {"divide without clipping", [] { return measure_error(naive::nothing); }},
      .mutants = {{"only one triangle of a clipped quadrilateral is drawn",
                   [] { return measure_error(one_triangle); }},
                  {"the crossing is measured from the wrong end of the edge",
                   [] { return measure_error(wrong_end); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
