#include <bit>

#include <glassbox/render/tile/tile_engine.h>

#include "study/extremes/common/depth.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/screen_scene.h"

namespace glassbox::study {
namespace c62 {

// Defines how depth is stored, cleared and compared.
struct DepthTest {
  std::uint32_t (*code)(DepthFormat, float depth) = depth_code;
  std::uint32_t clear = kEmptyDepth;
  bool (*passes)(std::uint32_t incoming, std::uint32_t stored) = in_front;
};

constexpr DepthFormat kFormats[] = {DepthFormat::kFloat32, DepthFormat::kFloat32Reversed,
                                    DepthFormat::kUnorm24, DepthFormat::kUnorm16};

// In an empty frame every triangle must be visible, from the near plane to the far plane itself; of
// two triangles the nearer one must be visible, in either order of drawing.
Outcome measure_error(const DepthTest& test) {
  int wrong = 0, questions = 0;
  for (const DepthFormat format : kFormats) {
    const bool reversed = format == DepthFormat::kFloat32Reversed;
    const auto code = [&](float depth) { return test.code(format, reversed ? 1 - depth : depth); };
    for (const float depth : {0.0f, 0.25f, 0.5f, 0.75f, 1.0f}) {
      wrong += !test.passes(code(depth), test.clear);
      ++questions;
      for (const float behind : {0.25f, 0.5f, 0.75f, 1.0f}) {
        if (behind <= depth) continue;
        wrong += !test.passes(code(depth), code(behind));
        wrong += test.passes(code(behind), code(depth));
        questions += 2;
      }
    }
  }
  return wrong_count_outcome(wrong, questions, "answers of the depth test are wrong");
}

// Draws a picture of 16 x 16 pixels in this format and returns the number of the triangle in each
// pixel, counted from 1.
CacheAlignedVector<std::uint32_t> shown_in(DepthFormat format, const TestedEngine& engine,
                                           const std::vector<ScreenTriangle>& triangles) {
  const bool reversed = format == DepthFormat::kFloat32Reversed;
  Camera camera;
  camera.lens = OrthographicLens{8, 0, 1};
  const View view =
      make_view(camera, 16, 16, reversed ? DepthRange::kReversed : DepthRange::kStandard).value();
  RenderSettings settings;
  settings.depth = format;
  settings.want_id = true;
  return engine.draw(screen_scene(triangles, 16, unlit_material()).scene, view, settings)
      .buffers.id.pixels;
}

ScreenTriangle corner_triangle(double size, float depth) {
  return {screen_vertex(0, 0, depth), screen_vertex(size, 0, depth), screen_vertex(0, size, depth)};
}

// Counts the pictures that stay black. Each has a single triangle over the whole picture, at one
// end of the depth range or in the middle.
int runs_without_a_picture(const TestedEngine& engine) {
  int black = 0;
  for (const DepthFormat format : kFormats) {
    for (const float depth : {0.0f, 0.5f, 1.0f}) {
      black += shown_in(format, engine, {corner_triangle(32, depth)})[0] != 1;
    }
  }
  return black;
}

// Draws a near and a far triangle, in both orders, small and large. Counts the pixels that show the
// far one, and the corner pixel if it shows none.
int pixels_that_show_the_far_one(const TestedEngine& engine) {
  int wrong = 0;
  for (const DepthFormat format : kFormats) {
    for (const double size : {16.0, 300.0}) {
      const ScreenTriangle near = corner_triangle(size, 0.25f), far = corner_triangle(size, 0.75f);
      const auto one = shown_in(format, engine, {near, far}),
                 other = shown_in(format, engine, {far, near});
      wrong += int(std::ranges::count(one, 2u) + std::ranges::count(other, 1u));
      wrong += int(one[0] == 0) + int(other[0] == 0);
    }
  }
  return wrong;
}

std::uint32_t raw_bits(DepthFormat, float depth) {
  return std::bit_cast<std::uint32_t>(depth);
}

Outcome measure_drawn_error(const TestedEngine& engine) {
  const int black = runs_without_a_picture(engine), far = pixels_that_show_the_far_one(engine);
  return must_be_zero(
      black + far,
      fmt::format("{} pictures stay black, {} pixels show the farther of two triangles", black,
                  far));
}

}  // namespace c62

ExtremeCase c62_reversed_clear() {
  using namespace c62;
  return {
      .id = "C-62",
      .name = "Cleared and compared the wrong way",
      .construction =
          "in each depth format: an empty buffer and one triangle at the near plane, at the far "
          "plane or between; then two triangles in both orders",
      .stage = "depth test",
      .right_answer = "a single triangle is always seen, and of two triangles the nearer one",
      .unit = "wrong answers",
      .oracle = Oracle::kProperty,
      .ours = {"depth codes grow with distance, and an empty buffer is behind all of them",
               [] { return measure_error({}); }},
      .naive = {"depth is cleared to 1 and tested with <, even for reversed depth",
                [] {
                  return measure_error(
                      {.code = raw_bits, .clear = std::bit_cast<std::uint32_t>(1.0f)});
                }},
      .mutants = {{"depth is cleared to the far plane's depth, which hides triangles on this plane",
                   [] { return measure_error({.clear = std::bit_cast<std::uint32_t>(1.0f)}); }},
                  {"the test is reversed",
                   [] {
                     return measure_error(
                         {.passes = [](std::uint32_t a, std::uint32_t b) { return a > b; }});
                   }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
