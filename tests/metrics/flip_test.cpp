#include <glassbox/compare/metrics/flip.h>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <glassbox/compare/metrics/flip_input.h>
#include <glassbox/compare/pixels/heat_map.h>

#include "tests/metrics/pictures.h"
#include "tests/support/catch.h"

namespace {

using namespace glassbox;
using test::WholePair;

bool same(const FlipErrors& a, const FlipErrors& b) {
  return a.pixels == b.pixels && a.mean == b.mean && a.median == b.median && a.p95 == b.p95 &&
         a.max == b.max;
}

WholePair noisy_pair(int width, int height, int channels) {
  return {test::noise_picture(width, height, channels, 1),
          test::picture<std::uint8_t>(width, height, channels, [](int x, int y, int c) {
            return (test::noise(x, y, c, 1) * 3 + test::noise(x, y, c, 2)) / 4;
          })};
}

StoredImage constant(int width, int height, std::vector<int> pixel) {
  return test::picture<std::uint8_t>(width, height, int(pixel.size()),
                                     [&](int, int, int c) { return pixel[std::size_t(c)]; });
}

std::uint8_t& sample(StoredImage& image, int x, int y, int channel) {
  return std::get<std::vector<std::uint8_t>>(
      image.samples)[std::size_t((y * image.width + x) * image.channels + channel)];
}

}  // namespace

TEST_CASE("the same pictures have no visible difference, exactly", "[metrics]") {
  for (const int channels : {1, 2, 3, 4}) {
    const StoredImage image = test::noise_picture(45, 33, channels, 1);
    const FlipErrors errors = flip(WholePair{image, image});
    CHECK(errors.pixels == 45 * 33);
    CHECK(errors.mean == 0);
    CHECK(errors.max == 0);
    CHECK(errors.p95 == 0);
  }
}

TEST_CASE("visible differences do not depend on which picture is the reference", "[metrics]") {
  for (const int channels : {1, 2, 3, 4}) {
    const WholePair pair = noisy_pair(45, 33, channels);
    CHECK(same(flip(pair), flip(pair.swapped())));
    CHECK(flip(pair).mean > 0);
  }
}

TEST_CASE("visible differences have the same bits for any tiles and threads", "[metrics]") {
  for (const int channels : {3, 4}) {
    const WholePair pair = noisy_pair(301, 77, channels);
    const FlipErrors whole = flip(pair);
    for (const TileSize tiles : {TileSize{1, 64}, {256, 1}, {37, 5}, {16, 31}}) {
      CHECK(same(flip(pair, tiles), whole));
    }
    for (const int threads : {1, 2, 5}) {
      const tbb::global_control more(tbb::global_control::max_allowed_parallelism, 5);
      tbb::task_arena arena(threads);
      arena.execute([&] { CHECK(same(flip(pair, {20, 7}), whole)); });
    }
  }
}

TEST_CASE("a tile of opaque pixels in a transparent picture is as in an opaque one", "[metrics]") {
  // The left half is opaque and the right half is not, so tiles of 10 pixels skip the second
  // background only on the left.
  const auto half = [](int x, int y, int c) {
    return c == 3 && x < 60 ? 255 : test::noise(x, y, c, 3);
  };
  const WholePair pair{test::picture<std::uint8_t>(120, 40, 4, half),
                       test::picture<std::uint8_t>(120, 40, 4, [&](int x, int y, int c) {
                         return c == 3 ? half(x, y, c) : half(x, y, c) ^ 8;
                       })};
  CHECK(same(flip(pair, {10, 40}), flip(pair)));
}

TEST_CASE("errors lie between 0 and 1 and their statistics are in order", "[metrics]") {
  for (int seed = 0; seed < 20; ++seed) {
    INFO("seed " << seed);
    const WholePair pair{test::noise_picture(9 + seed, 40 - seed, 3, seed),
                         test::noise_picture(9 + seed, 40 - seed, 3, seed + 100)};
    const FlipErrors errors = flip(pair);
    CHECK(errors.mean > 0);
    CHECK(errors.max <= 1);
    CHECK(errors.mean <= errors.max);
    CHECK(errors.median <= errors.p95);
    CHECK(errors.p95 <= errors.max + 0x1p-17);
  }
}

TEST_CASE("the farthest colours of a monitor have an error of 1", "[metrics]") {
  // Green and blue have the largest distance by definition. In a constant picture the exponent 1 -
  // feature is 1.
  const FlipErrors errors =
      flip(WholePair{constant(30, 30, {0, 255, 0}), constant(30, 30, {0, 0, 255})});
  // The colours are rounded before the power: by a few 2^-24 of values up to 1, which CIELAB
  // multiplies by 500.
  CHECK(std::abs(errors.mean - 1) < 2e-6);
  CHECK(errors.max <= 1);
}

TEST_CASE("pictures of any small size have an error, beyond their edges the edge goes on",
          "[metrics]") {
  for (const int width : {1, 2, 7}) {
    for (const int height : {1, 3, 10}) {
      const FlipErrors small = flip(WholePair{constant(width, height, {200, 10, 10}),
                                              constant(width, height, {10, 10, 200})});
      const FlipErrors large =
          flip(WholePair{constant(50, 50, {200, 10, 10}), constant(50, 50, {10, 10, 200})});
      CHECK(small.mean == large.mean);
      CHECK(small.max == large.max);
    }
  }
}

TEST_CASE("grey is the colour with three equal samples", "[metrics]") {
  const WholePair grey = noisy_pair(45, 33, 1);
  const auto colour = [](const StoredImage& image) {
    return test::picture<std::uint8_t>(image.width, image.height, 3, [&](int x, int y, int) {
      return std::get<std::vector<std::uint8_t>>(image.samples)[std::size_t(y * image.width + x)];
    });
  };
  CHECK(same(flip(grey), flip(WholePair{colour(grey.reference), colour(grey.test)})));
}

TEST_CASE("16-bit samples 257 times as large look like the bytes", "[metrics]") {
  for (const int channels : {1, 2, 3, 4}) {
    const WholePair bytes = noisy_pair(45, 33, channels);
    const WholePair words{test::deepened(bytes.reference), test::deepened(bytes.test)};
    CHECK(same(flip(bytes), flip(words)));
  }
}

TEST_CASE("a step of 16 bits that bytes do not have is seen", "[metrics]") {
  const auto at = [](int value) {
    return test::picture<std::uint16_t>(20, 20, 1, [=](int, int, int) { return value; });
  };
  CHECK(flip(WholePair{at(30000), at(30001)}).mean > 0);
}

TEST_CASE("an opaque alpha changes nothing", "[metrics]") {
  const WholePair pair = noisy_pair(45, 33, 3);
  const auto opaque = [](const StoredImage& image) {
    return test::picture<std::uint8_t>(image.width, image.height, 4, [&](int x, int y, int c) {
      return c == 3 ? 255
                    : std::get<std::vector<std::uint8_t>>(
                          image.samples)[std::size_t(3 * (y * image.width + x) + c)];
    });
  };
  CHECK(same(flip(pair), flip(WholePair{opaque(pair.reference), opaque(pair.test)})));
}

TEST_CASE("a difference in alpha alone is seen, whatever the colour", "[metrics]") {
  for (const int grey : {0, 128, 255}) {
    const FlipErrors errors = flip(WholePair{constant(30, 30, {grey, grey, grey, 255}),
                                             constant(30, 30, {grey, grey, grey, 128})});
    INFO("grey " << grey);
    CHECK(errors.mean > 0.1);
  }
}

TEST_CASE("what lies under a pixel without any alpha is not seen", "[metrics]") {
  CHECK(flip(WholePair{constant(20, 20, {255, 0, 0, 0}), constant(20, 20, {0, 255, 9, 0})}).max ==
        0);
}

TEST_CASE("pixels that are left out neither count nor show around them", "[metrics]") {
  const StoredImage image = test::noise_picture(60, 50, 3, 1);
  WholePair pair{image, image};
  sample(pair.test, 30, 20, 0) ^= 0x80;
  CHECK(flip(pair).max > 0);
  REQUIRE(pair.selection.exclude({30, 20, 1, 1}));
  CHECK(flip(pair).pixels == 60 * 50 - 1);
  CHECK(flip(pair).max == 0);
}

TEST_CASE("a single wrong pixel shows as far as the filters reach and no farther", "[metrics]") {
  const StoredImage image = constant(64, 64, {90, 90, 90});
  WholePair pair{image, image};
  sample(pair.test, 30, 20, 1) = 0;
  const Image<std::uint8_t> levels = flip_heat_map(pair);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      INFO(x << ", " << y);
      // In the corners of the square the filters' weights are smaller than the rounding error.
      if (std::hypot(x - 30, y - 20) <= kFlipHalo) CHECK(levels.at(x, y) > 0);
      if (std::max(std::abs(x - 30), std::abs(y - 20)) > kFlipHalo) CHECK(levels.at(x, y) == 0);
    }
  }
  CHECK(levels.at(30, 20) == *std::max_element(levels.pixels.begin(), levels.pixels.end()));
}

TEST_CASE("the heat map has the levels of the errors and marks what is left out", "[metrics]") {
  WholePair pair = noisy_pair(300, 70, 3);
  REQUIRE(pair.selection.exclude({0, 0, 300, 3}));
  const Image<std::uint8_t> levels = flip_heat_map(pair);
  const FlipErrors errors = flip(pair);
  std::uint8_t hottest = 0;
  double sum = 0;
  for (int y = 0; y < 70; ++y) {
    for (int x = 0; x < 300; ++x) {
      const std::uint8_t level = levels.at(x, y);
      CHECK((level == kHeatNotCompared) == (y < 3));
      if (level == kHeatNotCompared) continue;
      hottest = std::max(hottest, level);
      sum += level;
    }
  }
  CHECK(int(hottest) == int(std::ceil(float(errors.max) * float(kHeatHottest))));
  // Levels are rounded up, so a level exceeds its error by less than one.
  const double mean_level = sum / double(errors.pixels);
  CHECK(mean_level >= errors.mean * kHeatHottest);
  CHECK(mean_level < errors.mean * kHeatHottest + 1);
}

TEST_CASE("the filters' short radii leave out less than 2^-32 of their weight", "[metrics]") {
  const auto beyond = [](double width, std::size_t radius) {
    double inside = 0, outside = 0;
    for (int r = -kColourRadius; r <= kColourRadius; ++r) {
      const double degrees = r / kPixelsPerDegree;
      const double weight = std::exp(-std::pow(std::numbers::pi * degrees, 2) / width);
      (std::size_t(std::abs(r)) <= radius ? inside : outside) += weight;
    }
    return outside / (inside + outside);
  };
  const FlipFilters& filters = flip_filters();
  CHECK(beyond(0.0047, filters.lightness.size()) < 0x1p-32);
  CHECK(beyond(0.0053, filters.red_green.size()) < 0x1p-32);
  // With one tap less the filter would leave out too much.
  CHECK(beyond(0.0047, filters.lightness.size() - 1) > 0x1p-32);
  CHECK(beyond(0.0053, filters.red_green.size() - 1) > 0x1p-32);
}

TEST_CASE("the separable filters multiply out to the kernels of the paper", "[metrics]") {
  // The weight of the centre is 1 minus the other weights.
  const auto tap = [](const auto& taps, int r) {
    double centre = 1;
    for (const float weight : taps) centre -= 2 * double(weight);
    const auto at = std::size_t(std::abs(r));
    return at == 0 ? centre : at <= taps.size() ? double(taps[at - 1]) : 0.0;
  };
  // Table 1 of the paper: a Gaussian of amplitude a and width b at a squared distance, in square
  // degrees.
  const auto gaussian = [](double a, double b, double square) {
    constexpr double kPi = std::numbers::pi;
    return a * std::sqrt(kPi / b) * std::exp(-kPi * kPi * square / b);
  };
  struct Kernel {
    std::array<double, 3> sums{};
    std::array<double, 3> at(int x, int y) const {
      return values[std::size_t(y + 10)][std::size_t(x + 10)];
    }
    std::array<std::array<std::array<double, 3>, 21>, 21> values{};
  } kernel;
  for (int y = -10; y <= 10; ++y) {
    for (int x = -10; x <= 10; ++x) {
      const double square = (x * x + y * y) / (kPixelsPerDegree * kPixelsPerDegree);
      const std::array<double, 3> values{
          gaussian(1, 0.0047, square), gaussian(1, 0.0053, square),
          gaussian(34.1, 0.04, square) + gaussian(13.5, 0.025, square)};
      kernel.values[std::size_t(y + 10)][std::size_t(x + 10)] = values;
      for (std::size_t i = 0; i < 3; ++i) kernel.sums[i] += values[i];
    }
  }
  const FlipFilters& filters = flip_filters();
  for (int y = -10; y <= 10; ++y) {
    for (int x = -10; x <= 10; ++x) {
      const auto product = [&](const auto& taps) { return tap(taps, x) * tap(taps, y); };
      const std::array<double, 3> products{
          product(filters.lightness), product(filters.red_green),
          double(filters.wide_share) * product(filters.wide_blue_yellow) +
              double(filters.narrow_share) * product(filters.narrow_blue_yellow)};
      for (std::size_t i = 0; i < 3; ++i) {
        INFO("kernel " << i << " at " << x << ", " << y);
        // The weight of the centre, below 1/2, is computed from up to 20 weights below 1/4, each
        // rounded by at most 2^-27.
        CHECK(std::abs(products[i] - kernel.at(x, y)[i] / kernel.sums[i]) < 20 * 0x1p-27);
      }
    }
  }
}

TEST_CASE("the median and the 95th percentile are ranks", "[metrics]") {
  // A picture of three wide constant parts: most pixels have one of three errors.
  const auto part = [](int step) {
    return test::picture<std::uint8_t>(400, 20, 1, [=](int x, int, int) {
      return 100 + (x < 160 ? 0 : x < 370 ? step : 4 * step);
    });
  };
  const FlipErrors errors = flip(WholePair{part(0), part(10)});
  const FlipErrors low = flip(WholePair{constant(20, 20, {100}), constant(20, 20, {110})});
  const FlipErrors high = flip(WholePair{constant(20, 20, {100}), constant(20, 20, {140})});
  CHECK(errors.median == low.median);  // 40 % of the pixels differ by 0, the next 52.5 % by 10
  CHECK(errors.p95 == high.median);
}
