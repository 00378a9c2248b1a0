#include <glassbox/base/rounding.h>

#include "study/extremes/kit/depth.h"
#include "study/extremes/kit/extreme_case.h"
#include "study/extremes/kit/sight.h"

namespace glassbox::study {
namespace c63 {

Outcome judge(DepthPath::Detour detour) {
  const DepthPath path{.format = DepthFormat::kFloat32Reversed, .detour = detour};
  const double around = detour == DepthPath::kNone ? 1e-7 : 5e-4;
  const double confused = coarsest_confused(path, 1000, around);
  return {confused,
          4 * double(unit_roundoff<float>),
          {},
          fmt::format("depths that are {:.2g} apart are confused at the distance 1,000", confused)};
}

// Two rectangles at right angles to the gaze, 8 u apart at the distance 1,000, in both orders: the
// nearer one must be visible.
Outcome judge_drawn(const Drawer& by) {
  static const std::vector<SightDrawn> pictures = [] {
    std::vector<SightDrawn> all;
    for (const bool near_first : {true, false}) {
      std::vector<EyeTriangle> panes;
      for (const bool near : {near_first, !near_first}) {
        const float z = -1000 - (near ? 0.0f : 8 * 0x1p-14f);
        panes.push_back({Point<Eye>{-4000, -4000, z}, {9000, -4000, z}, {-4000, 9000, z}});
      }
      Vista vista = vista_of(panes, PerspectiveLens{1, 0.1, 1e4}, 32);
      store_depth(vista, DepthFormat::kFloat32Reversed);
      vista.separation = 4 * 0x1p-24;
      all.emplace_back(std::move(vista));
    }
    return all;
  }();
  return worst_of(pictures, by);
}

}  // namespace c63

ExtremeCase c63_reversed_through_gl() {
  using namespace c63;
  return {
      .id = "C-63",
      .name = "Reversed depth by way of [-1, 1]",
      .construction = "near 0.1, far 10,000, reversed float, at the distance 1,000",
      .stage = "projection",
      .right =
          "4 u: the matrix gives depth in [0, 1] at once, so small depths keep all their digits",
      .unit = "relative separation",
      .oracle = Oracle::kAnalytic,
      .ours = {"depth in [0, 1]", [] { return judge(DepthPath::kNone); }},
      .naive = {"OpenGL's z in [-1, 1], then z/2 + 1/2",
                [] { return judge(DepthPath::kThroughGl); }},
      .mutants = {{"reversed after the divide, as 1 - z",
                   [] { return judge(DepthPath::kSubtracted); }}},
      .drawn = judge_drawn,
  };
}

}  // namespace glassbox::study
