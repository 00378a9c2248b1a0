#include "study/extremes/common/attribute.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/ray_cast.h"
#include "study/naive/attribute.h"

namespace glassbox::study {
namespace c66 {

constexpr int kSide = 256;

// The corners are 1e-3, 1 and 1e6 units away; there are 1024 texels from the first corner to the
// other two.
Outcome measure_error(const AttributeAt& at) {
  const AttributeTriangle judged{
      {screen_vertex(-200, -180, 0.5f, 1e3f), screen_vertex(700, 20, 0.5f, 1),
       screen_vertex(40, 900, 0.5f, 1e-6f)},
      {0, 1, 1}};
  return measure_attribute_error(at, judged, kSide, 1024);
}

Outcome measure_drawn_error(const TestedEngine& engine) {
  static const RayCastReference picture(textured_ray_scene(
      {{Point<Eye>{-0.0006f, -0.0004f, -0.001f}, {0.6f, -0.1f, -1}, {-1e5f, 9e5f, -1e6f}}},
      {{{{0, 0}, {1, 0}, {1, 1}}}}, PerspectiveLens{1.0, 0.0005, 2e6}, 128, {1024, 64},
      Wrap::kClampToEdge));
  return picture.measure_error(engine);
}

}  // namespace c66

ExtremeCase c66_inverse_w() {
  using namespace c66;
  return {
      .id = "C-66",
      .name = "Distances from 0.001 to a million in one triangle",
      .construction = "w = 1e-3, 1, 1e6 at the corners, 1,024 texels between them",
      .stage = "interpolate",
      .right_answer =
          "1/w is a sum of positive numbers, so no digits cancel: the error is at most 14 e of "
          "1,024 texels = 8.5e-4, with the unit roundoff e = 2^-24",
      .unit = "texel",
      .oracle = Oracle::kRational,
      .ours = {"a full division", [] { return measure_error(pipeline_attribute); }},
      .naive = {"u/w times an interpolated w", [] { return measure_error(naive::with_linear_w); }},
      .mutants = {{"an approximate reciprocal of 12 bits",
                   [] { return measure_error(naive::with_raw_reciprocal); }},
                  {"affine interpolation", [] { return measure_error(naive::affine); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
