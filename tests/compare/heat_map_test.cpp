// Tests the levels and colours of a heat map.
#include "tests/support/catch.h"

#include <cmath>
#include <limits>
#include <vector>

#include "tests/compare/pictures.h"

#include <glassbox/compare/pixels/heat_map.h>

namespace glassbox::test {
namespace {

const StoredImage& image_of(Format format) {
  static const StoredImage images[] = {blank(1, 1, 1, Format::kBytes),
                                       blank(1, 1, 1, Format::kShorts),
                                       blank(1, 1, 1, Format::kFloats)};
  return images[std::size_t(format)];
}

std::uint32_t end_of(Format format) {
  if (format == Format::kBytes) return 255;
  return format == Format::kShorts ? 65535 : 1u << 24;
}

// Perceived brightness, approximately: stored values with the luma weights of Rec. 709.
double brightness(const Rgba8& c) {
  return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
}

TEST_CASE("more steps are never a lower level, and the scale begins and ends where it says") {
  for (const Format format : kFormats) {
    const StoredImage& image = image_of(format);
    INFO(name_of(format));
    CHECK(heat_level(0, image) == kHeatSame);
    CHECK(heat_level(1, image) == 1);
    int last = 0;
    const std::uint32_t end = end_of(format);
    for (std::uint32_t steps = 1; steps <= end; steps += format == Format::kFloats ? 97 : 1) {
      const int level = heat_level(steps, image);
      if (level < last || level < 1 || level > kHeatHottest) {
        INFO(steps << " steps: level " << level << " after " << last);
        CHECK(false);
        return;
      }
      last = level;
    }
    CHECK(heat_level(end, image) == kHeatHottest);
    CHECK(heat_level(end - 1, image) <= kHeatHottest);
    CHECK(heat_level(kUnbounded, image) == kHeatHottest);
    CHECK(heat_level(std::min(kUnbounded - 1, end + 1), image) == kHeatHottest);
    // Each doubling of the steps raises the level by the same number, up to rounding.
    for (std::uint32_t steps = 1; steps * 4 <= end; steps *= 2) {
      const int climb = heat_level(steps * 2, image) - heat_level(steps, image);
      const int next = heat_level(steps * 4, image) - heat_level(steps * 2, image);
      CHECK(std::abs(climb - next) <= 1);
    }
  }
}

TEST_CASE("the same is black, a single step is plainly visible, the hottest is white") {
  const auto& colours = heat_colours();
  CHECK(colours[kHeatSame] == Rgba8{0, 0, 0, 255});
  CHECK(colours[kHeatHottest] == Rgba8{255, 255, 255, 255});
  CHECK(brightness(colours[1]) > 50);
  for (const Rgba8& colour : colours) CHECK(colour.a == 255);
}

TEST_CASE("colours grow brighter with the level, and no two levels share one") {
  const auto& colours = heat_colours();
  for (std::size_t level = 2; level <= kHeatHottest; ++level) {
    const std::size_t below = level == kHeatHottest ? level_of_ramp(kHeatHottest - 1) : level - 1;
    if (!is_heat(std::uint8_t(level))) continue;
    INFO("level " << level);
    // Rounding down may make a colour darker by one step of one channel.
    CHECK(brightness(colours[level]) > brightness(colours[below]) - 1);
    CHECK(!(colours[level] == colours[below]));
  }
  for (const std::size_t level : {32u, 64u, 128u, 192u, 254u}) {
    CHECK(brightness(colours[level]) > brightness(colours[level / 2]));
  }
}

TEST_CASE("what is left out and what is set aside have colours that no difference has") {
  const auto& colours = heat_colours();
  for (const std::size_t special : {kHeatNotCompared, kHeatMovedEdge, kHeatBelowThreshold}) {
    for (std::size_t level = 0; level < colours.size(); ++level) {
      if (level == special) continue;
      const int apart = std::abs(colours[level].r - colours[special].r) +
                        std::abs(colours[level].g - colours[special].g) +
                        std::abs(colours[level].b - colours[special].b);
      INFO("levels " << special << " and " << level);
      CHECK(apart > 60);
    }
  }
}

TEST_CASE("no difference has a level of what is set aside") {
  const StoredImage bytes = blank(1, 1, 1, Format::kBytes);
  for (std::uint32_t steps = 1; steps <= 255; ++steps) CHECK(is_heat(heat_level(steps, bytes)));
  const StoredImage shorts = blank(1, 1, 1, Format::kShorts);
  for (std::uint32_t steps = 1; steps <= 65535; ++steps) {
    if (!is_heat(heat_level(steps, shorts))) FAIL(steps << " steps");
  }
  CHECK(heat_level(255, bytes) == kHeatHottest);
}

TEST_CASE("a heat map has the level of each pixel's difference") {
  Random random(41);
  for (const Format format : kFormats) {
    const StoredImage reference = random_picture(random, 9, 6, 3, format);
    StoredImage test = reference;
    for (int i = 0; i < 12; ++i) {
      const int x = int(random.integer(0, 8)), y = int(random.integer(0, 5));
      const int channel = int(random.integer(0, 2));
      set_sample(test, x, y, channel, random_sample(random, format));
    }
    Selection selection(9, 6);
    REQUIRE(selection.exclude(PixelBox{2, 1, 3, 3}));
    const PicturePair pair{reference, test, selection};
    const Image<std::uint8_t> levels = heat_map(pair);
    const Image<Rgba8> picture = heat_picture(levels);
    REQUIRE(levels.width == 9);
    REQUIRE(levels.height == 6);
    REQUIRE(picture.width == 9);
    REQUIRE(picture.height == 6);
    std::vector<std::uint32_t> steps(9);
    for (int y = 0; y < 6; ++y) {
      row_differences(pair, y, steps);
      for (int x = 0; x < 9; ++x) {
        const bool compared = selection.compares(x, y);
        CHECK(int(levels.at(x, y)) == (compared ? int(heat_level(steps[std::size_t(x)], reference))
                                                : int(kHeatNotCompared)));
        CHECK(picture.at(x, y) == heat_colours()[levels.at(x, y)]);
      }
    }
  }
}

TEST_CASE("pictures that are the same have a black heat map") {
  const StoredImage image = golden("teapot.png");
  const Selection all(image.width, image.height);
  const Image<std::uint8_t> levels = heat_map({image, image, all});
  CHECK(levels == Image<std::uint8_t>(image.width, image.height, kHeatSame));
}

}  // namespace
}  // namespace glassbox::test
