#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/ray_cast.h"
#include "study/extremes/common/texel.h"
#include "study/naive/attribute.h"

namespace glassbox::study {
namespace c68 {

constexpr int kSize = 8;

int modulo(int n, int m) {
  return ((n % m) + m) % m;
}

// The right texel for the coordinate k/64. The texture has 8 texels, so k is in eighths of a texel;
// everything is computed in integers.
int exact_texel(Wrap wrap, int k) {
  const int texel = (k - modulo(k, 8)) / 8;
  switch (wrap) {
    case Wrap::kRepeat:
      return modulo(texel, kSize);
    case Wrap::kMirroredRepeat: {
      const int folded = modulo(texel, 2 * kSize);
      return folded < kSize ? folded : 2 * kSize - 1 - folded;
    }
    case Wrap::kClampToEdge:
      return std::clamp(texel, 0, kSize - 1);
  }
  return 0;
}

Outcome measure_error(const TexelAt& texel_at) {
  int wrong = 0, all = 0;
  std::string first;
  for (const auto& [wrap, name] : {std::pair{Wrap::kRepeat, "repeated"},
                                   {Wrap::kMirroredRepeat, "mirrored"},
                                   {Wrap::kClampToEdge, "clamped"}}) {
    for (int k = -256; k <= 256; ++k, ++all) {
      const int texel = texel_at(wrap, float(k) / 64, kSize);
      if (texel == exact_texel(wrap, k)) continue;
      if (wrong++ == 0) first = fmt::format(": {} at {}, {}", texel, k / 64.0, name);
    }
  }
  return wrong_count_outcome(wrong, all, "texels are wrong" + first);
}

// A wall with 8 x 8 texels and coordinates from -4 to 4, in each of the three wrap modes.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<RayCastReference> walls = [] {
    std::vector<RayCastReference> all;
    for (const Wrap wrap : {Wrap::kRepeat, Wrap::kMirroredRepeat, Wrap::kClampToEdge}) {
      const Point<Eye> a{-1, -1, -2}, b{1, -1, -2.5f}, c{1, 1, -3}, d{-1, 1, -2.5f};
      all.emplace_back(textured_ray_scene(
          {{a, b, c}, {a, c, d}}, {{{{-4, 4}, {4, 4}, {4, -4}}}, {{{-4, 4}, {4, -4}, {-4, -4}}}},
          PerspectiveLens{0.8, 0.5, 8.0}, 256, {kSize, kSize}, wrap));
    }
    return all;
  }();
  return worst_of(walls, engine);
}

}  // namespace c68

ExtremeCase c68_texture_wrap() {
  using namespace c68;
  return {
      .id = "C-68",
      .name = "Wrapping negatives and exactly 1",
      .construction =
          "texture coordinates from -4 to 4 in steps of 1/64 over 8 texels, repeated, mirrored and "
          "clamped",
      .stage = "texture",
      .right_answer =
          "the coordinate is rounded down, then the remainder that is not negative is taken; "
          "mirroring is about the border between two texels",
      .unit = "texels wrong",
      .oracle = Oracle::kInteger,
      .ours = {"floor", [] { return measure_error(pipeline_texel); }},
      .naive = {"(int)(u size) % size", [] { return measure_error(naive::scaled_then_wrapped); }},
      .mutants = {{"truncated in place of rounded down",
                   [] { return measure_error(naive::truncated); }},
                  {"mirrored at the centres of texels",
                   [] { return measure_error(naive::mirrored_about_texels); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
