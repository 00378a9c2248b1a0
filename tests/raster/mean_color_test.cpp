#include <algorithm>
#include <cmath>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/raster/mean_color.h>

#include "tests/support/catch.h"

namespace glassbox {
namespace {

constexpr std::array kCounts{1, 2, 4, 8, 16};

std::vector<Rgba8> any_colors(Random& random, int count) {
  std::vector<Rgba8> colors;
  const int range = random.integer(0, 1) == 0 ? 255 : 3;  // also similar bytes, where ties occur
  const int first = int(random.integer(0, 255 - range));
  const auto byte = [&] { return std::uint8_t(first + random.integer(0, range)); };
  for (int i = 0; i < count; ++i) colors.push_back({byte(), byte(), byte(), byte()});
  return colors;
}

// The inverse of the sRGB transfer function of IEC 61966-2-1.
long double light_of(std::uint8_t byte) {
  const long double v = byte / 255.0L;
  return v <= 0.04045L ? v / 12.92L : std::pow((v + 0.055L) / 1.055L, 2.4L);
}
long double bytes_of(long double light) {
  const long double v =
      light <= 0.0031308L ? light * 12.92L : 1.055L * std::pow(light, 1 / 2.4L) - 0.055L;
  return v * 255;
}

}  // namespace

TEST_CASE("equal colours have themselves as mean") {
  for (const Transfer transfer : {Transfer::kSrgb, Transfer::kNone}) {
    for (const int count : kCounts) {
      for (int b = 0; b < 256; ++b) {
        const auto byte = std::uint8_t(b);
        const Rgba8 color{byte, std::uint8_t(255 - b), byte, byte};
        REQUIRE(mean_color(transfer, std::vector<Rgba8>(std::size_t(count), color)) == color);
      }
    }
  }
}

TEST_CASE("the mean is that of light, to half a byte, whatever the order") {
  Random random(4);
  for (int i = 0; i < 20000; ++i) {
    std::vector<Rgba8> colors = any_colors(random, kCounts[std::size_t(i % 5)]);
    const Rgba8 mean = mean_color(Transfer::kSrgb, colors);
    long double light = 0;
    for (const Rgba8& c : colors) light += light_of(c.r);
    // The table and the rounding to float change the mean by 2^-23 of itself, less than 2e-5 bytes.
    const long double exact = bytes_of(light / (long double)colors.size());
    CHECK(std::abs(exact - mean.r) < 0.5L + 2e-5L);
    std::reverse(colors.begin(), colors.end());
    CHECK(mean_color(Transfer::kSrgb, colors) == mean);
  }
}

TEST_CASE("without a transfer, and for alpha, the mean is that of bytes, halves rounded up") {
  Random random(5);
  for (int i = 0; i < 20000; ++i) {
    const std::vector<Rgba8> colors = any_colors(random, kCounts[std::size_t(i % 5)]);
    const Rgba8 mean = mean_color(Transfer::kNone, colors);
    double g = 0, a = 0;
    for (const Rgba8& c : colors) g += c.g, a += c.a;
    // Exact: the count is a power of two.
    CHECK(mean.g == std::floor(g / double(colors.size()) + 0.5));
    CHECK(mean.a == std::floor(a / double(colors.size()) + 0.5));
    CHECK(mean_color(Transfer::kSrgb, colors).a == mean.a);
  }
}

}  // namespace glassbox
