#include <glassbox/base/rounding.h>

#include "study/extremes/common/depth.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/ray_cast.h"

namespace glassbox::study {
namespace c63 {

Outcome measure_error(DepthPath::Detour detour) {
  const DepthPath path{.format = DepthFormat::kFloat32Reversed, .detour = detour};
  const double around = detour == DepthPath::kNone ? 1e-7 : 5e-4;
  const double confused = coarsest_confused(path, 1000, around);
  return {confused,
          4 * double(unit_roundoff<float>),
          {},
          fmt::format("depths that are {:.2g} apart are confused at the distance 1,000", confused)};
}

// Two rectangles at right angles to the gaze at the distance 1,000, separated by 8 u of that
// distance (u is the unit roundoff), in both orders of drawing: the nearer one must be visible.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<RayCastReference> pictures = [] {
    std::vector<RayCastReference> all;
    for (const bool near_first : {true, false}) {
      std::vector<EyeTriangle> panes;
      for (const bool near : {near_first, !near_first}) {
        const float z = -1000 - (near ? 0.0f : 8 * 0x1p-14f);
        panes.push_back({Point<Eye>{-4000, -4000, z}, {9000, -4000, z}, {-4000, 9000, z}});
      }
      RayScene ray_scene = make_ray_scene(panes, PerspectiveLens{1, 0.1, 1e4}, 32);
      store_depth(ray_scene, DepthFormat::kFloat32Reversed);
      ray_scene.separation = 4 * 0x1p-24;
      all.emplace_back(std::move(ray_scene));
    }
    return all;
  }();
  return worst_of(pictures, engine);
}

}  // namespace c63

ExtremeCase c63_reversed_through_gl() {
  using namespace c63;
  return {
      .id = "C-63",
      .name = "Reversed depth by way of [-1, 1]",
      .construction =
          "near plane 0.1, far plane 10,000, reversed float depth at the distance 1,000",
      .stage = "projection",
      .right_answer =
          "distances that differ by 4 u are distinguished, because the matrix gives depth in [0, "
          "1] directly, so small depths keep all their digits",
      .unit = "relative separation",
      .oracle = Oracle::kAnalytic,
      .ours = {"depth in [0, 1]", [] { return measure_error(DepthPath::kNone); }},
      .naive = {"OpenGL's z in [-1, 1], then z/2 + 1/2",
                [] { return measure_error(DepthPath::kThroughGl); }},
      .mutants = {{"reversed after the divide, as 1 - z",
                   [] { return measure_error(DepthPath::kSubtracted); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
