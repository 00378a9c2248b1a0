#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "study/extremes/kit/depth.h"
#include "study/extremes/kit/extreme_case.h"
#include "study/naive/depth.h"

#include <glassbox/base/random.h>

namespace glassbox::study {

namespace c61 {

// z = m 2^e exactly, so floor(z (2^24 - 1) + 1/2) = (2 m (2^24 - 1) + 2^-e) >> (1 - e), in whole numbers.
std::int64_t exact_code(float z) {
  int exponent = 0;
  const std::int64_t m = std::int64_t(std::ldexp(std::frexp(z, &exponent), 24));
  const int shift = 24 - exponent;
  if (shift > 60) return 0;
  __extension__ typedef __int128 Int128;
  return std::int64_t((2 * Int128(m) * 16777215 + (Int128(1) << shift)) >> (shift + 1));
}

Outcome judge(std::uint32_t (*code)(float)) {
  std::int64_t worst = 0, wrong = 0, tried = 0;
  const auto ask = [&](float z) {
    const std::int64_t off = std::abs(std::int64_t(code(z)) - exact_code(z));
    worst = std::max(worst, off);
    wrong += off != 0;
    ++tried;
  };
  for (const float z : {0.0f, 1.0f, 1.0f - 0x1p-24f, 0x1p-24f, 0x1p-25f, 0.5f, 0x1p-149f}) ask(z);
  Random random(61);
  for (int i = 0; i < 100000; ++i) ask(float(random.unit()));
  // Halves and their neighbours.
  for (int k = 1; k < 16777215; k += 16381) {
    const float tie = float((k + 0.5) / 16777215);
    for (const float z : {std::nextafter(tie, 0.0f), tie, std::nextafter(tie, 1.0f)}) ask(z);
  }
  return {double(worst), 0, {}, fmt::format("{} of {} codes wrong", wrong, tried)};
}

std::uint32_t pipeline_code(float z) {
  return depth_code(DepthFormat::kUnorm24, z);
}

}  // namespace c61

ExtremeCase c61_unorm24_ends() {
  using namespace c61;
  ExtremeCase c;
  c.id = "C-61";
  c.name = "The ends of 24-bit depth";
  c.construction =
      "0, 1, 1 - 2^-24, the smallest float, 100,000 random depths, halves between codes";
  c.stage = "depth";
  c.right = "floor(z (2^24 - 1) + 1/2) in 128 bits; 1 is 0xffffff";
  c.unit = "codes";
  c.oracle = Oracle::kInteger;
  c.ours = {"in double", [] { return judge(pipeline_code); }};
  c.naive = {"z 2^24, 24 bits kept", [] { return judge(naive::unorm24_wrapping); }};
  c.mutants = {{"depth end points: truncated in place of rounded",
                [] { return judge(naive::unorm24_truncating); }},
               {"in float", [] { return judge(naive::unorm24_in_float); }}};
  return c;
}

}  // namespace glassbox::study
