#include <cstdlib>

#include "study/extremes/common/depth.h"
#include "study/extremes/common/drawn_coverage.h"
#include "study/extremes/common/extreme_case.h"
#include "study/naive/depth.h"

#include <glassbox/base/random.h>

namespace glassbox::study {
namespace c61 {

// The right code of a depth z, in integers. With z = m 2^e exactly, floor(z (2^24 - 1) + 1/2) is (2
// m (2^24 - 1) + 2^-e) >> (1 - e).
std::int64_t exact_code(float z) {
  int exponent = 0;
  const std::int64_t m = std::int64_t(std::ldexp(std::frexp(z, &exponent), 24));
  const int shift = 24 - exponent;
  if (shift > 60) return 0;
  __extension__ typedef __int128 Int128;
  return std::int64_t((2 * Int128(m) * 16777215 + (Int128(1) << shift)) >> (shift + 1));
}

Outcome measure_error(std::uint32_t (*code)(float)) {
  ErrorsAboveBound errors(0);
  const auto ask = [&](float z) {
    errors.add(double(std::abs(std::int64_t(code(z)) - exact_code(z))));
  };
  for (const float z : {0.0f, 1.0f, 1.0f - 0x1p-24f, 0x1p-24f, 0x1p-25f, 0.5f, 0x1p-149f}) ask(z);
  Random random(61);
  for (int i = 0; i < 100000; ++i) ask(float(random.unit()));
  // Tests the depths halfway between two codes, and the floats next to them.
  for (int k = 1; k < 16777215; k += 16381) {
    const float tie = float((k + 0.5) / 16777215);
    for (const float z : {std::nextafter(tie, 0.0f), tie, std::nextafter(tie, 1.0f)}) ask(z);
  }
  return errors.outcome("codes are wrong");
}

std::uint32_t pipeline_code(float z) {
  return depth_code(DepthFormat::kUnorm24, z);
}

// Triangles parallel to the screen, whose depth is everywhere that of their corners: checks the
// stored codes in both integer formats.
Outcome measure_drawn_error(const TestedEngine& engine) {
  int wrong = 0, all = 0;
  for (const auto& [format, steps] :
       {std::pair{DepthFormat::kUnorm24, 0xffffff}, {DepthFormat::kUnorm16, 0xffff}}) {
    for (const float depth : {0.0f, 0x1p-26f, 1e-5f, 0.25f, 0.333f, 0.9999f, 1.0f}) {
      for (const float size : {12.0f, 200.0f}) {
        const ScreenScene flat =
            screen_scene({{screen_vertex(0, 0, depth), screen_vertex(double(size), 0, depth),
                           screen_vertex(0, double(size), depth)}},
                         16, unlit_material());
        RenderSettings settings = plain_settings();
        settings.depth = format;
        settings.want_depth = true;
        const auto code = engine.draw(flat.scene, flat.view, settings).buffers.depth.at(1, 1);
        wrong += double(code) != std::floor(double(depth) * steps + 0.5);
        ++all;
      }
    }
  }
  return wrong_count_outcome(wrong, all, "depth codes are not the nearest ones");
}

}  // namespace c61

ExtremeCase c61_unorm24_ends() {
  using namespace c61;
  return {
      .id = "C-61",
      .name = "The ends of 24-bit depth",
      .construction =
          "the depths 0, 1, 1 - 2^-24 and the smallest float, 100,000 random depths, and depths "
          "halfway between codes",
      .stage = "depth",
      .right_answer =
          "the code is floor(z (2^24 - 1) + 1/2), computed in 128 bits; depth 1 has the code "
          "0xffffff",
      .unit = "codes",
      .oracle = Oracle::kInteger,
      .ours = {"rounded in double", [] { return measure_error(pipeline_code); }},
      .naive = {"z 2^24, of which 24 bits are kept",
                [] { return measure_error(naive::unorm24_wrapping); }},
      .mutants = {{"truncated in place of rounded",
                   [] { return measure_error(naive::unorm24_truncating); }},
                  {"rounded in float", [] { return measure_error(naive::unorm24_in_float); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
