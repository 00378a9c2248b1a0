// The samples in a page: a reader unpacks the samples of the picture, bit by bit; and which parts
// of the picture the page contains.
#include <algorithm>
#include <bit>
#include <cstring>
#include <type_traits>

#include <glassbox/base/random.h>
#include <glassbox/compare/report/page_blob.h>
#include <glassbox/compare/report/page_crops.h>

#include "tests/report/blob.h"
#include "tests/support/catch.h"

namespace glassbox {
namespace {

// A sample of any bits: floats may be NaN with any payload, infinite or subnormal.
template <class Sample>
Sample any_bits(Random& random) {
  if constexpr (std::is_same_v<Sample, float>) {
    return std::bit_cast<float>(std::uint32_t(random.bits()));
  } else {
    return Sample(random.bits());
  }
}

template <class Sample>
StoredImage any_image(Random& random) {
  StoredImage image;
  image.width = int(random.integer(1, 40));
  image.height = int(random.integer(1, 40));
  image.channels = int(random.integer(1, 4));
  std::vector<Sample> samples(image.pixels() * std::size_t(image.channels));
  for (Sample& sample : samples) sample = any_bits<Sample>(random);
  image.samples = std::move(samples);
  return image;
}

PixelBox any_box(Random& random, const StoredImage& image) {
  PixelBox box;
  box.x = int(random.integer(0, image.width - 1));
  box.y = int(random.integer(0, image.height - 1));
  box.width = int(random.integer(1, image.width - box.x));
  box.height = int(random.integer(1, image.height - box.y));
  return box;
}

// The bytes of the boxes, taken directly from the picture.
template <class Sample>
std::vector<Sample> cut_out(const StoredImage& image, std::span<const PixelBox> boxes) {
  const auto& samples = std::get<std::vector<Sample>>(image.samples);
  std::vector<Sample> out;
  for (const PixelBox& box : boxes) {
    for (int y = box.y; y < box.y + box.height; ++y) {
      for (int x = box.x; x < box.x + box.width; ++x) {
        for (int channel = 0; channel < image.channels; ++channel) {
          out.push_back(samples[std::size_t((y * image.width + x) * image.channels + channel)]);
        }
      }
    }
  }
  return out;
}

template <class Sample>
void check_round_trips(std::uint64_t seed) {
  Random random(seed);
  for (int i = 0; i < 100; ++i) {
    const StoredImage image = any_image<Sample>(random);
    std::vector<PixelBox> boxes;
    for (auto n = random.integer(1, 4); n > 0; --n) boxes.push_back(any_box(random, image));
    const auto blob = encode_blob(image, boxes);
    REQUIRE(blob);
    const auto expected = cut_out<Sample>(image, boxes);
    const auto read = test::decode_blob<Sample>(*blob, boxes, image.channels);
    INFO("seed " << seed << ", picture " << i << ": " << image.width << " x " << image.height
                 << ", channels " << image.channels);
    REQUIRE(read.size() == expected.size());
    REQUIRE(std::equal(read.begin(), read.end(), expected.begin(),
                       [](Sample a, Sample b) { return std::memcmp(&a, &b, sizeof a) == 0; }));
  }
}

Differences regions_at(Random& random, int width, int height, int count) {
  Differences differences;
  for (int i = 0; i < count; ++i) {
    Region region;
    region.box.x = int(random.integer(0, width - 1));
    region.box.y = int(random.integer(0, height - 1));
    region.box.width = int(random.integer(1, width - region.box.x));
    region.box.height = int(random.integer(1, height - region.box.y));
    region.worst = {int(random.integer(region.box.x, region.box.x + region.box.width - 1)),
                    int(random.integer(region.box.y, region.box.y + region.box.height - 1))};
    differences.regions.push_back(region);
  }
  return differences;
}

bool contains(const PixelBox& box, PixelPosition pixel) {
  return pixel.x >= box.x && pixel.x < box.x + box.width && pixel.y >= box.y &&
         pixel.y < box.y + box.height;
}

}  // namespace

TEST_CASE("samples of 8 bits, 16 bits and floats come out of a blob bit by bit", "[report]") {
  check_round_trips<std::uint8_t>(1);
  check_round_trips<std::uint16_t>(2);
  check_round_trips<float>(3);
}

TEST_CASE("a picture within the limit is shown as one piece, whatever differs", "[report]") {
  const CropLimits limits{.whole_pixels = 600, .side = 10, .count = 3};
  const std::vector<PixelBox> whole{{0, 0, 30, 20}};
  CHECK(crops_of(30, 20, nullptr, limits) == whole);
  Random random(4);
  const Differences differences = regions_at(random, 30, 20, 5);
  CHECK(crops_of(30, 20, &differences, limits) == whole);
  CHECK(crops_of(30, 21, &differences, limits) != std::vector<PixelBox>{{0, 0, 30, 21}});
}

TEST_CASE(
    "crops lie in the picture, keep to their limits, and show the worst pixel of the worst regions",
    "[report]") {
  Random random(5);
  for (int i = 0; i < 500; ++i) {
    const int width = int(random.integer(1, 3000)), height = int(random.integer(1, 3000));
    const Differences differences = regions_at(random, width, height, int(random.integer(1, 20)));
    const CropLimits limits{.whole_pixels = 0, .side = int(random.integer(1, 1024)), .count = 8};
    const auto crops = crops_of(width, height, &differences, limits);
    INFO("case " << i << ": " << width << " x " << height << ", side " << limits.side);
    REQUIRE(!crops.empty());
    REQUIRE(crops.size() <= limits.count);
    for (const PixelBox& crop : crops) {
      REQUIRE(crop.x >= 0);
      REQUIRE(crop.y >= 0);
      REQUIRE(crop.width >= 1);
      REQUIRE(crop.height >= 1);
      REQUIRE(crop.width <= limits.side);
      REQUIRE(crop.height <= limits.side);
      REQUIRE(crop.x + crop.width <= width);
      REQUIRE(crop.y + crop.height <= height);
    }
    // Regions are included in order, so that none is shown instead of a worse one.
    const auto shown = [&](const Region& region) {
      return std::any_of(crops.begin(), crops.end(),
                         [&](const PixelBox& crop) { return contains(crop, region.worst); });
    };
    const auto first_left_out =
        std::find_if_not(differences.regions.begin(), differences.regions.end(), shown);
    if (first_left_out != differences.regions.end()) REQUIRE(crops.size() == limits.count);
    REQUIRE(first_left_out != differences.regions.begin());
  }
}

TEST_CASE("a large picture of which nothing is known to differ is shown by its corner",
          "[report]") {
  const CropLimits limits{.whole_pixels = 100, .side = 50, .count = 8};
  CHECK(crops_of(400, 30, nullptr, limits) == std::vector<PixelBox>{{0, 0, 50, 30}});
}

}  // namespace glassbox
