// The small pictures of a page's list: exact means, and differences that are seen.
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/compare/pixels/heat_map.h>
#include <glassbox/compare/report/page_thumbnail.h>

#include "tests/support/catch.h"

namespace glassbox {
namespace {

// The samples as the numbers from 0 to 255 that the header gives them.
std::vector<std::uint64_t> levels_of(const StoredImage& image) {
  std::vector<std::uint64_t> levels;
  const auto add = [&](double share) { levels.push_back(std::uint64_t(share * 255 + 0.5)); };
  if (const auto* bytes = std::get_if<std::vector<std::uint8_t>>(&image.samples)) {
    levels.assign(bytes->begin(), bytes->end());
  } else if (const auto* shorts = std::get_if<std::vector<std::uint16_t>>(&image.samples)) {
    for (const std::uint16_t sample : *shorts) add(sample / 65535.0);
  } else {
    const auto& floats = std::get<std::vector<float>>(image.samples);
    const auto [low, high] = std::minmax_element(floats.begin(), floats.end());
    for (const float sample : floats) {
      add(*low < *high ? (double(sample) - *low) / (double(*high) - *low) : 0);
    }
  }
  return levels;
}

StoredImage random_bytes(Random& random, int width, int height, int channels) {
  StoredImage image{width, height, channels, {}};
  std::vector<std::uint8_t> samples(image.pixels() * std::size_t(channels));
  for (std::uint8_t& sample : samples) sample = std::uint8_t(random.bits());
  image.samples = std::move(samples);
  return image;
}

// A picture of 16 bits (`bits` is 16) or of floats (32).
StoredImage random_samples(Random& random, int width, int height, int channels, int bits) {
  if (bits == 8) return random_bytes(random, width, height, channels);
  StoredImage image{width, height, channels, {}};
  const std::size_t count = image.pixels() * std::size_t(channels);
  std::vector<std::uint16_t> shorts(count);
  for (std::uint16_t& sample : shorts) sample = std::uint16_t(random.bits());
  if (bits == 16) {
    image.samples = std::move(shorts);
  } else {
    std::vector<float> floats;
    for (const std::uint16_t sample : shorts) floats.push_back(float(sample) / 1000 - 20);
    image.samples = std::move(floats);
  }
  return image;
}

StoredImage heat_with(int width, int height,
                      const std::vector<std::pair<PixelPosition, std::uint8_t>>& levels) {
  StoredImage heat{width, height, 1, {}};
  std::vector<std::uint8_t> samples(heat.pixels(), kHeatSame);
  for (const auto& [at, level] : levels) samples[std::size_t(at.y * width + at.x)] = level;
  heat.samples = std::move(samples);
  return heat;
}

PagePicture picture(const char* name, StoredImage image) {
  return {name, std::make_shared<const StoredImage>(std::move(image)), {}};
}

Image<Rgba8> thumbnail_of(StoredImage test) {
  return page_thumbnail(std::vector{picture("test", std::move(test))});
}

// Whether |mean - sum / count| <= 1/2, in whole numbers.
bool is_nearest(std::uint64_t mean, std::uint64_t sum, std::uint64_t count) {
  const std::uint64_t twice = 2 * sum, low = 2 * count * mean;
  return (twice > low ? twice - low : low - twice) <= count;
}

std::size_t pixels_of_colour(const Image<Rgba8>& image, const Rgba8& colour) {
  return std::size_t(std::count(image.pixels.begin(), image.pixels.end(), colour));
}

}  // namespace

TEST_CASE("each pixel of a thumbnail is the nearest value to the mean of its box", "[report]") {
  Random random(11);
  for (int i = 0; i < 90; ++i) {
    const int width = int(random.integer(1, 400));
    const int height = int(random.integer(1, 300));
    const int channels = random.integer(0, 1) == 0 ? 1 : 3;
    const int bits = 8 << (i % 3);
    const StoredImage image = random_samples(random, width, height, channels, bits);
    const std::vector<std::uint64_t> samples = levels_of(image);
    const Image<Rgba8> thumbnail = thumbnail_of(image);
    INFO("case " << i << ": " << width << " x " << height << ", " << channels << " channels of "
                 << bits << " bits");
    REQUIRE(thumbnail.width >= 1);
    REQUIRE(thumbnail.height >= 1);
    REQUIRE(thumbnail.width <= std::min(width, kThumbnailWidth));
    REQUIRE(thumbnail.height <= std::min(height, kThumbnailHeight));
    // Each source pixel is found in the box that the header's formula gives.
    std::vector<std::array<std::uint64_t, 3>> sums(thumbnail.pixels.size());
    std::vector<std::uint64_t> counts(thumbnail.pixels.size());
    const auto place = [](int pixel, int size, int count) {
      int found = 0;
      while ((found + 1) * size / count <= pixel) ++found;
      return found;
    };
    for (int y = 0; y < height; ++y) {
      const int row = place(y, height, thumbnail.height);
      for (int x = 0; x < width; ++x) {
        const auto box = thumbnail.index(place(x, width, thumbnail.width), row);
        ++counts[box];
        for (std::size_t k = 0; k < 3; ++k) {
          const auto first = std::size_t(y * width + x) * std::size_t(channels);
          sums[box][k] += samples[first + (channels == 1 ? 0 : k)];
        }
      }
    }
    for (std::size_t box = 0; box < counts.size(); ++box) {
      const Rgba8& pixel = thumbnail.pixels[box];
      REQUIRE(counts[box] > 0);
      REQUIRE(is_nearest(pixel.r, sums[box][0], counts[box]));
      REQUIRE(is_nearest(pixel.g, sums[box][1], counts[box]));
      REQUIRE(is_nearest(pixel.b, sums[box][2], counts[box]));
    }
  }
}

TEST_CASE("a thumbnail keeps the shape of its picture, and is not larger than it", "[report]") {
  Random random(12);
  const auto size = [&](int width, int height) {
    const Image<Rgba8> made = thumbnail_of(random_bytes(random, width, height, 1));
    return std::pair(made.width, made.height);
  };
  CHECK(size(640, 360) == std::pair(96, 54));
  CHECK(size(360, 640) == std::pair(36, 64));
  CHECK(size(20, 10) == std::pair(20, 10));
  CHECK(size(5000, 1) == std::pair(96, 1));
  CHECK(size(1, 5000) == std::pair(1, 64));
}

TEST_CASE("thumbnails of 16 bits, of floats and of transparent pictures are 8-bit colours",
          "[report]") {
  CHECK(thumbnail_of({2, 1, 1, std::vector<std::uint16_t>{65535, 257}}).pixels[1] ==
        Rgba8{1, 1, 1, 255});
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const Image<Rgba8> floats =
      thumbnail_of({6, 1, 1, std::vector<float>{-1, 3, 1, kInfinity, -kInfinity, std::nanf("")}});
  const std::array<int, 6> expected{0, 255, 128, 255, 0, 0};
  for (std::size_t i = 0; i < expected.size(); ++i) CHECK(floats.pixels[i].r == expected[i]);
  // A picture without any finite sample has no range, and no value in one.
  CHECK(thumbnail_of({1, 1, 1, std::vector<float>{std::nanf("")}}).pixels[0].r == 0);
  CHECK(thumbnail_of({1, 1, 4, std::vector<std::uint8_t>{0, 0, 0, 0}}).pixels[0].r == 230);
}

TEST_CASE("a single differing pixel of a large picture is nine pixels of its thumbnail",
          "[report]") {
  Random random(13);
  for (int i = 0; i < 100; ++i) {
    const int width = int(random.integer(300, 900)), height = int(random.integer(200, 600));
    const int x = int(random.integer(20, width - 21)), y = int(random.integer(20, height - 21));
    const auto level = std::uint8_t(random.integer(1, kHeatBelowThreshold - 1));
    std::vector<PagePicture> pictures;
    pictures.push_back(picture("test", random_bytes(random, width, height, 3)));
    pictures.push_back(picture("heat", heat_with(width, height, {{{x, y}, level}})));
    INFO(width << " x " << height << ", pixel " << x << ", " << y);
    REQUIRE(pixels_of_colour(page_thumbnail(pictures), heat_colours()[level]) >= 9);
  }
}

TEST_CASE("where everything differs, the thumbnail still shows the picture", "[report]") {
  constexpr std::uint8_t kLevel = 9;
  std::vector<std::pair<PixelPosition, std::uint8_t>> all;
  for (int x = 0; x < 40; ++x) all.push_back({{x, 0}, kLevel});
  std::vector<PagePicture> pictures;
  Random random(15);
  pictures.push_back(picture("test", random_bytes(random, 40, 1, 1)));
  pictures.push_back(picture("heat", heat_with(40, 1, all)));
  const Image<Rgba8> thumbnail = page_thumbnail(pictures);
  for (int x = 0; x < 40; ++x) {
    const int grey =
        std::get<std::vector<std::uint8_t>>(pictures[0].image->samples)[std::size_t(x)];
    CHECK(thumbnail.at(x, 0).g == (grey + heat_colours()[kLevel].g) / 2);
  }
}

TEST_CASE("what is set aside covers only its own box, and no difference", "[report]") {
  std::vector<PagePicture> pictures;
  Random random(14);
  pictures.push_back(picture("test", random_bytes(random, 20, 20, 3)));
  pictures.push_back(picture("heat", heat_with(20, 20,
                                               {{{3, 3}, kHeatMovedEdge},
                                                {{10, 10}, kHeatBelowThreshold},
                                                {{11, 10}, std::uint8_t(9)},
                                                {{15, 15}, kHeatNotCompared}})));
  const Image<Rgba8> thumbnail = page_thumbnail(pictures);
  CHECK(pixels_of_colour(thumbnail, heat_colours()[kHeatMovedEdge]) == 1);
  CHECK(pixels_of_colour(thumbnail, heat_colours()[kHeatBelowThreshold]) == 0);
  CHECK(pixels_of_colour(thumbnail, heat_colours()[9]) == 9);
  CHECK(pixels_of_colour(thumbnail, heat_colours()[kHeatNotCompared]) == 1);
}

}  // namespace glassbox
