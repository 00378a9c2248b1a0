// The pictures of two eyes by `render`: both drawn, or one warped from the other, with the surfaces
// behind the visible ones or without; and the maps that `stereo` computes from them.
#include <algorithm>
#include <cstdlib>

#include <glassbox/render/renderer.h>
#include <glassbox/render/stereo/disparity.h>
#include <glassbox/render/stereo/monocular.h>
#include <glassbox/render/stereo/window_violations.h>

#include "tests/same_bytes/configurations.h"
#include "tests/same_bytes/generated_pair.h"
#include "views/layers/second_eye.h"

namespace glassbox {
namespace {

using test::Configuration;
using test::GeneratedPair;
using test::RunResult;

TileOptions options_of(const test::GeneratedCase& c, const Configuration& configuration) {
  TileOptions options = c.options;
  options.target = configuration.target;
  options.threads = configuration.threads;
  return options;
}

bool is_seen_through(const Scene& scene) {
  return std::ranges::any_of(scene.materials, [](const Material& material) {
    return material.alpha_mode == AlphaMode::kBlend;
  });
}

// How many pixels without a depth differ from the background's colour: translucent surfaces in
// front of the background, and edges.
std::size_t colored_without_depth(const Framebuffer& buffers, const Rgba8& background) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < buffers.color.pixels.size(); ++i)
    count += buffers.depth.pixels[i] == kEmptyDepth && buffers.color.pixels[i] != background;
  return count;
}

struct Counts {
  std::size_t pairs = 0, seen_through = 0, layered = 0, without_depth = 0;
};

// Draws the left eye by the stages and warps the right eye from it in all configurations. Other
// tests compare the engines, so the warp, which takes very little time, can be tested on many
// pictures.
void check_warp(std::uint64_t seed, Counts& counts) {
  auto pair = test::generate_pair(seed, 260);
  if (!pair) return;
  ++counts.pairs;
  test::GeneratedCase& c = pair->scene;
  c.settings.want_depth = true;
  counts.seen_through += is_seen_through(c.scene);
  Renderer renderer(c.scene, c.settings.transfer, EngineKind::kStaged);
  const Rendering left = renderer.render(eye_view(c.view, pair->eyes, Side::kLeft), c.settings);
  counts.without_depth += colored_without_depth(left.buffers, c.settings.background);
  test::check_same_result(seed, [&](const Configuration& configuration) {
    views::SecondEye second;
    Image<Rgba8> right;
    RunResult made;
    made.add_number(
        "holes",
        second.warp({left.buffers.color, left.buffers.depth}, c.view, pair->eyes,
                    {1, configuration.threads, configuration.target, c.settings.depth}, right));
    made.add("right", right);
    return made;
  });
}

// Tests all of `--stereo pair --second-eye warp:N`. If N is more than 1, translucent surfaces are
// replaced by masked ones.
void check_warped_pair(std::uint64_t seed, Counts& counts) {
  auto pair = test::generate_pair(seed, 130);
  if (!pair) return;
  ++counts.pairs;
  test::GeneratedCase& c = pair->scene;
  const int layers = 1 + int(seed % 3);
  if (layers > 1) {
    test::make_opaque_or_masked(c.scene);
    c.settings.samples = 1;
    ++counts.layered;
  }
  REQUIRE(views::check_second_eye(c.scene, c.settings, layers));
  const auto warped_by = [&](EngineKind kind, const Configuration& configuration) {
    Renderer renderer(c.scene, c.settings.transfer, kind, options_of(c, configuration));
    views::SecondEye second;
    views::WarpedPair both;
    views::render_pair_by_warp(
        renderer, c.view, pair->eyes, c.settings,
        {layers, configuration.threads, configuration.target, c.settings.depth}, second, both);
    RunResult made;
    made.add("left", both.rendering.left.color);
    made.add("right", both.rendering.right.color);
    made.add("distance", both.rendering.right.distance);
    made.add_number("holes", both.holes);
    return made;
  };
  const RunResult staged = warped_by(EngineKind::kStaged, {});
  test::check_same_result(seed, [&](const Configuration& configuration) {
    RunResult made = warped_by(EngineKind::kTile, configuration);
    const std::string difference = made.difference_from(staged);
    if (!difference.empty()) FAIL_CHECK("seed " << seed << ", by the stages: " << difference);
    return made;
  });
}

// Tests the surfaces behind a picture, which are drawn for the layers of a warp and of `views
// layers build`.
void check_behind(std::uint64_t seed, Counts& counts) {
  const auto pair = test::generate_pair(seed, 130);
  if (!pair) return;
  ++counts.pairs;
  test::GeneratedCase c = pair->scene;
  test::make_opaque_or_masked(c.scene);  // EyePicture::behind_depth requires this
  c.settings.want_depth = c.settings.want_distance = c.settings.want_id = true;
  c.settings.samples = 1;
  Renderer staged(c.scene, c.settings.transfer, EngineKind::kStaged);
  Image<std::uint32_t> behind = staged.render(c.view, c.settings).buffers.depth;
  for (std::size_t i = seed % 3; i < behind.pixels.size(); i += 3) behind.pixels[i] = kEmptyDepth;
  const auto drawn_by = [&](Renderer& renderer) {
    Rendering drawn;
    renderer.render(c.view, c.settings, drawn, &behind);
    RunResult made;
    made.add("color", drawn.buffers.color);
    made.add("depth", drawn.buffers.depth);
    made.add("distance", drawn.buffers.distance);
    made.add("id", drawn.buffers.id);
    return made;
  };
  const RunResult expected = drawn_by(staged);
  test::check_same_result(seed, [&](const Configuration& configuration) {
    Renderer tiled(c.scene, c.settings.transfer, EngineKind::kTile, options_of(c, configuration));
    RunResult made = drawn_by(tiled);
    const std::string difference = made.difference_from(expected);
    if (!difference.empty()) FAIL_CHECK("seed " << seed << ", by the stages: " << difference);
    return made;
  });
}

void check_stereo_maps(std::uint64_t seed, Counts& counts) {
  const auto pair = test::generate_pair(seed, 100);
  if (!pair) return;
  ++counts.pairs;
  const test::GeneratedCase& c = pair->scene;
  StereoSettings settings{c.settings};
  settings.render.want_distance = settings.render.want_id = true;
  const auto maps_by = [&](EngineKind kind, const Configuration& configuration) {
    Renderer renderer(c.scene, c.settings.transfer, kind, options_of(c, configuration));
    const StereoRendering eyes = renderer.render_pair(c.view, pair->eyes, settings);
    const Image<float> left = disparity_map(c.view, pair->eyes, eyes.left.distance),
                       right = disparity_map(c.view, pair->eyes, eyes.right.distance);
    const MonocularMaps alone = monocular_maps(left, right);
    const WindowViolations cut = window_violations(c.scene, {eyes.left, left}, {eyes.right, right});
    RunResult made;
    made.add("left picture", eyes.left.color);
    made.add("right picture", eyes.right.color);
    made.add("left disparity", left);
    made.add("right disparity", right);
    made.add("seen by the left eye alone", alone.left);
    made.add("seen by the right eye alone", alone.right);
    made.add("cut by the left window", cut.left);
    made.add("cut by the right window", cut.right);
    return made;
  };
  const RunResult staged = maps_by(EngineKind::kStaged, {});
  test::check_same_result(seed, [&](const Configuration& configuration) {
    RunResult made = maps_by(EngineKind::kTile, configuration);
    const std::string difference = made.difference_from(staged);
    if (!difference.empty()) FAIL_CHECK("seed " << seed << ", by the stages: " << difference);
    return made;
  });
}

template <class Check>
Counts check_seeds(std::uint64_t count, const Check& check) {
  Counts counts;
  for (std::uint64_t seed = 0; seed < count; ++seed) check(seed, counts);
  return counts;
}

TEST_CASE("a second eye that is warped has the same bytes by every target and number of threads",
          "[eyes]") {
  const Counts counts = check_seeds(400 / test::kCaseDivisor, check_warp);
  // Scenes of the kind in which such colours were once lost.
  CHECK(counts.seen_through > counts.pairs / 8);
  CHECK(counts.without_depth > 100 * counts.pairs);
}

TEST_CASE("a pair whose second eye is warped has the same bytes by both engines in every way",
          "[eyes]") {
  const Counts counts = check_seeds(30 / test::kCaseDivisor, check_warped_pair);
  CHECK(counts.layered > counts.pairs / 3);
}

TEST_CASE("what is behind any picture has the same bytes by both engines in every way", "[eyes]") {
  CHECK(check_seeds(40 / test::kCaseDivisor, check_behind).pairs > 25 / test::kCaseDivisor);
}

TEST_CASE("what stereo sees in two pictures is the same by both engines in every way", "[eyes]") {
  CHECK(check_seeds(20 / test::kCaseDivisor, check_stereo_maps).pairs > 12 / test::kCaseDivisor);
}

TEST_CASE("ten thousand warped eyes and some hundred of the rest", "[.same-bytes]") {
  check_seeds(10000, check_warp);
  check_seeds(800, check_warped_pair);
  check_seeds(800, check_behind);
  check_seeds(800, check_stereo_maps);
  SUCCEED();
}

}  // namespace
}  // namespace glassbox
