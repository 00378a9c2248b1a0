#include <glassbox/base/rounding.h>

#include "study/extremes/kit/depth.h"
#include "study/extremes/kit/extreme_case.h"

namespace glassbox::study {
namespace c63 {

Outcome judge(DepthPath::Detour detour) {
  const DepthPath path{.format = DepthFormat::kFloat32Reversed, .detour = detour};
  const double around = detour == DepthPath::kNone ? 1e-7 : 5e-4;
  const double confused = coarsest_confused(path, 1000, around);
  return {confused,
          4 * double(unit_roundoff<float>),
          {},
          fmt::format("depths {:.2g} apart confused at the distance 1,000", confused)};
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
  };
}

}  // namespace glassbox::study
