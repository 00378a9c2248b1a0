#include "tests/images/stereo/pictures.h"
#include "tests/support/catch.h"

#include <glassbox/images/stereo/layouts.h>

namespace {

using namespace glassbox;
using test::noise;

struct Eyes {
  Image<Rgba8> left, right;
};

Eyes noisy_eyes(int width, int height) {
  Random random(std::uint64_t(width * 100 + height));
  Eyes eyes;
  eyes.left = noise(width, height, random);
  eyes.right = noise(width, height, random);
  return eyes;
}

}  // namespace

TEST_CASE("pair has the left eye on the left, cross-eyed on the right") {
  const auto [left, right] = noisy_eyes(5, 3);
  const auto pair = make_stereo_layout(left, right, StereoLayout::kPair);
  const auto crossed = make_stereo_layout(left, right, StereoLayout::kCrossEyed);
  REQUIRE((pair && crossed));
  REQUIRE((pair->width == 10 && pair->height == 3));
  REQUIRE((crossed->width == 10 && crossed->height == 3));
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 5; ++x) {
      CHECK(pair->at(x, y) == left.at(x, y));
      CHECK(pair->at(x + 5, y) == right.at(x, y));
      CHECK(crossed->at(x, y) == right.at(x, y));
      CHECK(crossed->at(x + 5, y) == left.at(x, y));
    }
  }
}

TEST_CASE("over-under has the left eye above") {
  const auto [left, right] = noisy_eyes(4, 7);
  const auto both = make_stereo_layout(left, right, StereoLayout::kOverUnder);
  REQUIRE(both);
  REQUIRE((both->width == 4 && both->height == 14));
  for (int y = 0; y < 7; ++y) {
    for (int x = 0; x < 4; ++x) {
      CHECK(both->at(x, y) == left.at(x, y));
      CHECK(both->at(x, y + 7) == right.at(x, y));
    }
  }
}

TEST_CASE("interlaced gives the left eye the even rows, one more where the height is odd") {
  for (const int height : {1, 2, 5, 6}) {
    CAPTURE(height);
    const auto [left, right] = noisy_eyes(3, height);
    const auto both = make_stereo_layout(left, right, StereoLayout::kInterlaced);
    REQUIRE(both);
    REQUIRE((both->width == 3 && both->height == height));
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < 3; ++x) {
        CHECK(both->at(x, y) == (y % 2 == 0 ? left : right).at(x, y));
      }
    }
  }
}

TEST_CASE(
    "layouts refuse eyes of different sizes and sizes that cannot be doubled, and take empty "
    "ones") {
  for (const auto& layout : all_stereo_layouts()) {
    CAPTURE(layout.name);
    CHECK(name_of(layout.value) == layout.name);
    const auto refused = make_stereo_layout({2, 2}, {2, 1}, layout.value);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().place == layout.name);
    Image<Rgba8> wide;
    wide.width = 1 << 30;  // the image still has no rows
    CHECK(make_stereo_layout(wide, wide, layout.value).has_value() ==
          (layout.value == StereoLayout::kInterlaced));
    CHECK(make_stereo_layout({}, {}, layout.value)->pixels.empty());
  }
}
