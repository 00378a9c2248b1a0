// Tests that metrics may leave out what no difference reaches.
#include <glassbox/compare/metrics/affected_box.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/compare/metrics/flip.h>
#include <glassbox/compare/metrics/ssim.h>

#include "tests/metrics/pictures.h"
#include "tests/support/catch.h"

namespace {

using namespace glassbox;
using test::WholePair;

constexpr int kWidth = 90, kHeight = 30;  // px; one tile of each metric

void change(WholePair& pair, int x, int y, int channel) {
  auto& samples = std::get<std::vector<std::uint8_t>>(pair.test.samples);
  samples[std::size_t((y * pair.test.width + x) * pair.test.channels + channel)] ^= 0x15;
}

WholePair equal_pair(int width, int height, int channels, int seed) {
  const StoredImage image = test::noise_picture(width, height, channels, seed);
  return {image, image};
}

// A pair that differs in its corners, in the corners of the centres of SSIM's windows, and in the
// pixel (x, y), each in all channels. If its only tile is the whole picture, nothing is left out,
// however far the filters reach.
WholePair pair_with_corners(int channels, int x, int y) {
  WholePair pair = equal_pair(kWidth, kHeight, channels, 7);
  for (int channel = 0; channel < channels; ++channel) {
    change(pair, 0, 0, channel);
    change(pair, kWidth - 1, kHeight - 1, channel);
    change(pair, kSsimWindow / 2, kSsimWindow / 2, channel);
    change(pair, kWidth - 1 - kSsimWindow / 2, kHeight - 1 - kSsimWindow / 2, channel);
    change(pair, x, y, channel);
  }
  return pair;
}

PixelBox box_pixel_by_pixel(const WholePair& pair, const PixelBox& tile, int reach,
                            const ChannelRange& channels) {
  const auto& reference = std::get<std::vector<std::uint8_t>>(pair.reference.samples);
  const auto& other = std::get<std::vector<std::uint8_t>>(pair.test.samples);
  int left = tile.x + tile.width, right = tile.x, top = tile.y + tile.height, bottom = tile.y;
  for (int y = 0; y < pair.reference.height; ++y) {
    for (int x = 0; x < pair.reference.width; ++x) {
      if (!pair.selection.compares(x, y)) continue;
      const int first = (y * pair.reference.width + x) * pair.reference.channels + channels.first;
      if (std::equal(reference.begin() + first, reference.begin() + first + channels.count,
                     other.begin() + first))
        continue;
      for (int at_y = y - reach; at_y <= y + reach; ++at_y) {
        for (int at_x = x - reach; at_x <= x + reach; ++at_x) {
          if (at_x < tile.x || at_x >= tile.x + tile.width) continue;
          if (at_y < tile.y || at_y >= tile.y + tile.height) continue;
          left = std::min(left, at_x), right = std::max(right, at_x + 1);
          top = std::min(top, at_y), bottom = std::max(bottom, at_y + 1);
        }
      }
    }
  }
  if (right <= left) return {};
  return {left, top, right - left, bottom - top};
}

}  // namespace

TEST_CASE("the affected box is what differences reach, pixel by pixel", "[metrics]") {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    const auto number = [&](int from, int to) { return int(random.integer(from, to)); };
    const int width = number(1, 40), height = number(1, 30), channels = number(1, 4);
    WholePair pair = equal_pair(width, height, channels, int(seed));
    const auto some_x = [&] { return number(0, width - 1); };
    const auto some_y = [&] { return number(0, height - 1); };
    for (int i = number(0, 4); i > 0; --i) {
      const int x = some_x(), y = some_y();
      change(pair, x, y, number(0, channels - 1));
    }
    for (int i = number(0, 2); i > 0; --i) {
      REQUIRE(pair.selection.exclude({some_x(), some_y(), number(1, 12), number(1, 12)}));
    }
    PixelBox tile{some_x(), some_y()};
    tile.width = number(1, width - tile.x);
    tile.height = number(1, height - tile.y);
    ChannelRange range{number(0, channels - 1)};
    range.count = number(1, channels - range.first);
    const int reach = number(0, 12);
    INFO("seed " << seed);
    CHECK(affected_box(pair, tile, reach, range) == box_pixel_by_pixel(pair, tile, reach, range));
  }
}

TEST_CASE("metrics that leave out equal places have the bits of the full computation",
          "[metrics]") {
  // The changed pixel stands at each distance from the borders of tiles of 8 x 8 and 20 x 6 pixels.
  for (const int channels : {1, 3, 4}) {
    for (int x = 20; x < 62; ++x) {
      const int y = 8 + x % 13;
      const WholePair pair = pair_with_corners(channels, x, y);
      INFO(channels << " channels, " << x << ", " << y);
      const PixelBox whole{0, 0, kWidth, kHeight};
      REQUIRE(affected_box(pair, whole, 0, {0, channels}) == whole);
      const FlipErrors errors = flip(pair);
      const SsimValues values = ssim(pair);
      for (const TileSize tiles : {TileSize{1, 1}, {8, 8}, {20, 6}}) {
        const FlipErrors some = flip(pair, tiles);
        CHECK(some.pixels == errors.pixels);
        CHECK(some.mean == errors.mean);
        CHECK(some.median == errors.median);
        CHECK(some.p95 == errors.p95);
        CHECK(some.max == errors.max);
        const SsimValues windows = ssim(pair, tiles);
        CHECK(windows.windows == values.windows);
        CHECK(windows.mean == values.mean);
        CHECK(windows.min == values.min);
      }
    }
  }
}
