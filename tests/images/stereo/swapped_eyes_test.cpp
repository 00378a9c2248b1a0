#include "tests/support/catch.h"

#include <algorithm>
#include <limits>
#include <string>

#include <glassbox/images/stereo/swapped_eyes.h>

#include "tests/images/stereo/pictures.h"

namespace {

using namespace glassbox;
using test::noise;

struct Scene {
  Image<Rgba8> left, right;
  Image<float> disparity;
};

// Returns noise, smoothed so that it can still be recognized after a shift by half a pixel.
Image<Rgba8> texture(int width, int height, Random& random, Rgba8 tint) {
  const Image<Rgba8> rough = noise(width + 2, height + 2, random);
  Image<Rgba8> smooth(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      int sum = 0;
      for (int dy = 0; dy < 3; ++dy) {
        for (int dx = 0; dx < 3; ++dx) sum += rough.at(x + dx, y + dy).r;
      }
      smooth.at(x, y) = {std::uint8_t(sum * tint.r / 2295), std::uint8_t(sum * tint.g / 2295),
                         std::uint8_t(sum * tint.b / 2295), 255};
    }
  }
  return smooth;
}

// Draws a far wall and a near object left of the middle in front of it. Each has a texture of its
// own colour and a disparity of its own in pixels, and is painted from far to near for each eye.
Scene near_left_of_far(int far_px, int near_px) {
  constexpr int kWidth = 160, kHeight = 60, kMargin = 20;
  Random random(77);
  const Image<Rgba8> wall = texture(kWidth + 2 * kMargin, kHeight, random, {255, 230, 180, 255});
  const Image<Rgba8> object = texture(50, 40, random, {220, 255, 240, 255});
  Scene scene{{kWidth, kHeight}, {kWidth, kHeight}, {kWidth, kHeight, float(far_px)}};
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      scene.left.at(x, y) = wall.at(x + kMargin, y);
      scene.right.at(x, y) = wall.at(x + kMargin - far_px, y);
    }
  }
  for (int y = 0; y < object.height; ++y) {
    for (int x = 0; x < object.width; ++x) {
      scene.left.at(20 + x, 10 + y) = object.at(x, y);
      scene.right.at(20 + x + near_px, 10 + y) = object.at(x, y);
      scene.disparity.at(20 + x, 10 + y) = float(near_px);
    }
  }
  return scene;
}

EyeOrder order_of(const Image<Rgba8>& left, const Image<Rgba8>& right, const Image<float>& map) {
  const auto evidence = pair_order(left, right, map);
  REQUIRE(evidence);
  CAPTURE(evidence->windows, evidence->in_order, evidence->swapped);
  CHECK(evidence->in_order + evidence->swapped <= evidence->windows);
  return evidence->order;
}

}  // namespace

TEST_CASE("a pair is in order or swapped, near objects before the window or behind it (C-78)") {
  for (const auto& [far_px, near_px] : {std::pair{4, -6}, {8, 2}, {-1, -9}, {1, -1}}) {
    CAPTURE(far_px, near_px);
    const Scene scene = near_left_of_far(far_px, near_px);
    CHECK(order_of(scene.left, scene.right, scene.disparity) == EyeOrder::kInOrder);
    CHECK(order_of(scene.right, scene.left, scene.disparity) == EyeOrder::kSwapped);
  }
}

TEST_CASE("the evidence: windows fit where the disparity puts them, and hardly elsewhere") {
  const Scene scene = near_left_of_far(4, -6);
  const auto evidence = pair_order(scene.left, scene.right, scene.disparity);
  REQUIRE(evidence);
  CHECK(evidence->windows > 1000);
  CHECK(evidence->in_order > 9 * evidence->swapped);
  CHECK(evidence->in_order_fit > 0.8);
  CHECK(evidence->swapped_fit < 0.3);
}

TEST_CASE(
    "an anaglyph with its channels swapped is told from one in order, for all glasses and "
    "methods") {
  const Scene scene = near_left_of_far(4, -6);
  for (const auto& glasses : all_glasses()) {
    for (const auto& method : all_anaglyph_methods()) {
      if (!anaglyph_matrix(method.value, glasses.value)) continue;
      CAPTURE(glasses.name, method.name);
      const auto right_way = make_anaglyph(scene.left, scene.right, method.value, glasses.value);
      const auto wrong_way = make_anaglyph(scene.right, scene.left, method.value, glasses.value);
      REQUIRE((right_way && wrong_way));
      const auto in_order = anaglyph_order(*right_way, glasses.value, scene.disparity);
      const auto swapped = anaglyph_order(*wrong_way, glasses.value, scene.disparity);
      REQUIRE((in_order && swapped));
      CHECK(in_order->order == EyeOrder::kInOrder);
      CHECK(swapped->order == EyeOrder::kSwapped);
    }
  }
}

TEST_CASE(
    "an anaglyph whose colours are light in one eye and dark in the other is judged all the same") {
  Scene scene = near_left_of_far(4, -6);
  for (Image<Rgba8>* eye : {&scene.left, &scene.right}) {
    for (Rgba8& pixel : eye->pixels) {  // red increases where green and blue decrease
      pixel.g = std::uint8_t(255 - pixel.r);
      pixel.b = pixel.g;
    }
  }
  const auto anaglyph = make_anaglyph(scene.left, scene.right, AnaglyphMethod::kMask);
  REQUIRE(anaglyph);
  const auto evidence = anaglyph_order(*anaglyph, Glasses::kRedCyan, scene.disparity);
  REQUIRE(evidence);
  CHECK(evidence->order == EyeOrder::kInOrder);
}

TEST_CASE(
    "the order is unknown without texture, without parallax, and for pictures of different "
    "things") {
  const Scene scene = near_left_of_far(4, -6);
  Random random(4);
  const Image<Rgba8> flat(160, 60, {90, 90, 90, 255});
  CHECK(order_of(flat, flat, scene.disparity) == EyeOrder::kUnknown);
  CHECK(order_of(scene.left, scene.left, Image<float>(160, 60, 0.0f)) == EyeOrder::kUnknown);
  CHECK(pair_order(scene.left, scene.right, Image<float>(160, 60, 0.4f))->windows == 0);
  for (int i = 0; i < 20; ++i) {
    const Image<Rgba8> one = texture(160, 60, random, {255, 255, 255, 255});
    const Image<Rgba8> other = texture(160, 60, random, {255, 255, 255, 255});
    CHECK(order_of(one, other, scene.disparity) == EyeOrder::kUnknown);
  }
}

TEST_CASE("disparities that are empty, or lead out of the picture, are left out") {
  Scene scene = near_left_of_far(4, -6);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  for (const float value : {nan, infinite, -infinite, 1e30f, 159.0f}) {
    CAPTURE(value);
    const auto evidence = pair_order(scene.left, scene.right, Image<float>(160, 60, value));
    REQUIRE(evidence);
    CHECK(evidence->windows == 0);
    CHECK(evidence->order == EyeOrder::kUnknown);
  }
  CHECK_FALSE(pair_order(scene.left, scene.right, Image<float>(160, 59)));
  CHECK_FALSE(pair_order(scene.left, Image<Rgba8>(1, 1), scene.disparity));
  CHECK_FALSE(anaglyph_order(scene.left, Glasses::kRedCyan, Image<float>(1, 60)));
  CHECK(pair_order({2, 2}, {2, 2}, {2, 2})->windows == 0);
}
