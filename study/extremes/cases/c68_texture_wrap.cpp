#include "study/extremes/kit/extreme_case.h"
#include "study/extremes/kit/texel.h"
#include "study/naive/attribute.h"

namespace glassbox::study {
namespace c68 {

constexpr int kSize = 8;

int modulo(int n, int m) {
  return ((n % m) + m) % m;
}

// In units of 1/64 of the texture, so an eighth of a texel: whole numbers.
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

Outcome judge(const TexelAt& texel_at) {
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
  return wrong_of(wrong, all, "texels wrong" + first);
}

}  // namespace c68

ExtremeCase c68_texture_wrap() {
  using namespace c68;
  return {
      .id = "C-68",
      .name = "Wrapping negatives and exactly 1",
      .construction = "-4 to 4 in steps of 1/64 over 8 texels, repeated, mirrored, clamped",
      .stage = "texture",
      .right = "floor, then the remainder that is not negative; a mirror lies between texels",
      .unit = "texels wrong",
      .oracle = Oracle::kInteger,
      .ours = {"floor", [] { return judge(pipeline_texel); }},
      .naive = {"(int)(u size) % size", [] { return judge(naive::scaled_then_wrapped); }},
      .mutants = {{"truncated in place of rounded down", [] { return judge(naive::truncated); }},
                  {"mirrored about texels", [] { return judge(naive::mirrored_about_texels); }}},
  };
}

}  // namespace glassbox::study
