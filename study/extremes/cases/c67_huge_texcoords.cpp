#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/ray_cast.h"
#include "study/extremes/common/texel.h"
#include "study/naive/attribute.h"

#include <glassbox/base/random.h>

namespace glassbox::study {
namespace c67 {

constexpr int kSize = 1024;

// Measures the distance in texels between the exact place of a texture coordinate and the sampled
// texel. The place is exact in double, because the coordinates are floats below 2^24.
Outcome measure_error(const TexelAt& texel_at) {
  WorstError worst;
  Random random(67);
  for (const double large : {1.0, 1e2, 1e4, 1e6, 8e6}) {
    for (int i = 0; i < 200; ++i) {
      const float t = float(random.between(-large, large));
      const double place = (double(t) - std::floor(double(t))) * kSize;
      const int texel = texel_at(Wrap::kRepeat, t, kSize);
      const double beside = std::max({texel - place, place - (texel + 1), 0.0});
      // If a coordinate is slightly below 0, its fraction, near 1, is rounded by up to 2^-25 of the
      // texture.
      worst.add(std::min(beside, kSize - beside), kSize * 0x1p-25,
                fmt::format("texel {} instead of {:.2f} at u = {}", texel, place, t),
                std::abs(double(t)));
    }
  }
  return worst.outcome();
}

// A wall whose texture coordinates span 4 repetitions of the texture and start at 4,096, where
// floats still have eleven bits for the place within a texture.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const RayCastReference wall(
      textured_ray_scene({{Point<Eye>{-1, -1, -2}, {1, -1, -2}, {0, 1, -2}}},
                         {{{{4096, -4096}, {4100, -4096}, {4098, -4100}}}},
                         PerspectiveLens{0.9, 0.5, 8.0}, 128, {16, 16}, Wrap::kRepeat));
  return wall.measure_error(engine);
}

}  // namespace c67

ExtremeCase c67_huge_texcoords() {
  using namespace c67;
  return {
      .id = "C-67",
      .name = "Huge texture coordinates",
      .construction =
          "a repeated row of 1,024 texels, with texture coordinates u from -8 million to 8 "
          "million, as floats",
      .stage = "texture",
      .right_answer =
          "the texel is that of the exact fraction, or one that is 2^-25 of the texture away, "
          "because the integer part is subtracted before scaling; the digits of u that a float "
          "cannot hold are lost before that (the condition number is |u|)",
      .unit = "texel",
      .oracle = Oracle::kRational,
      .ours = {"wrapped, then scaled", [] { return measure_error(pipeline_texel); }},
      .naive = {"scaled to a 32-bit integer, then wrapped",
                [] { return measure_error(naive::scaled_then_wrapped); }},
      .mutants = {{"scaled in float, then wrapped",
                   [] { return measure_error(naive::scaled_in_float); }},
                  {"truncated in place of rounded down",
                   [] { return measure_error(naive::truncated); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
