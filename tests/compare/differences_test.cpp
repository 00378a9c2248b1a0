// Compares the counts, the first pixel, the box and the largest step with a second computation,
// pixel by pixel.
#include "tests/support/catch.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/compare/pictures.h"

#include <glassbox/compare/pixels/selection.h>

namespace glassbox::test {
namespace {

// Returns the distance of two samples given as doubles: the difference of whole numbers, or for
// floats the number of steps from one float to the next.
std::uint32_t sample_distance(double a, double b, Format format, bool nan_equals_nan) {
  if (format != Format::kFloats) return std::uint32_t(std::fabs(a - b));
  if (std::isnan(a) && std::isnan(b) && nan_equals_nan) return 0;
  if (std::isnan(a) || std::isnan(b)) return kUnbounded;
  if (std::isinf(a) || std::isinf(b)) return a == b ? 0 : kUnbounded;
  const auto place = [](double value) {
    const auto bits = std::int64_t(std::bit_cast<std::uint32_t>(float(std::fabs(value))));
    return std::signbit(value) ? -bits - 1 : bits;
  };
  return std::uint32_t(std::llabs(place(a) - place(b)));
}

struct Case {
  StoredImage reference, test;
  Selection selection;
  Format format;
  bool nan_equals_nan;
  PicturePair pair() const { return {reference, test, selection, nan_equals_nan}; }
};

std::uint32_t steps_at(const Case& c, int x, int y) {
  std::uint32_t largest = 0;
  if (!c.selection.compares(x, y)) return 0;
  for (int channel = 0; channel < c.reference.channels; ++channel) {
    largest = std::max(
        largest, sample_distance(sample_at(c.reference, x, y, channel),
                                 sample_at(c.test, x, y, channel), c.format, c.nan_equals_nan));
  }
  return largest;
}

// Returns a random float; NaN, infinities and both zeros are among them.
double odd_float(Random& random) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double odd[] = {std::nan(""), kInfinity, -kInfinity, 0.0, -0.0};
  return odd[random.integer(0, 4)];
}

Case random_case(Random& random) {
  const Format format = kFormats[random.integer(0, 2)];
  const int width = int(random.integer(1, 40)), height = int(random.integer(1, 30));
  const int channels = int(random.integer(1, 4));
  Case c{random_picture(random, width, height, channels, format),
         {},
         {width, height},
         format,
         random.integer(0, 1) == 1};
  const auto anywhere = [&](StoredImage& image, double value) {
    const int x = int(random.integer(0, width - 1)), y = int(random.integer(0, height - 1));
    set_sample(image, x, y, int(random.integer(0, channels - 1)), value);
  };
  for (auto i = random.integer(-5, 5); format == Format::kFloats && i > 0; --i) {
    anywhere(c.reference, odd_float(random));
  }
  c.test = c.reference;
  // The number of changed samples is zero, small, or up to the number of all samples.
  const std::int64_t most[] = {0, 5, std::int64_t(width) * height * channels};
  for (auto i = random.integer(0, most[random.integer(0, 2)]); i > 0; --i) {
    const bool odd = format == Format::kFloats && random.integer(0, 3) == 0;
    anywhere(c.test, odd ? odd_float(random) : random_sample(random, format));
  }
  for (auto i = random.integer(-2, 2); i > 0; --i) {
    const PixelBox box{int(random.integer(-3, width - 1)), int(random.integer(-3, height - 1)),
                       int(random.integer(4, 20)), int(random.integer(4, 20))};
    REQUIRE(c.selection.exclude(box));
  }
  return c;
}

TEST_CASE("the differences of random pictures are those of a pixel-by-pixel computation") {
  Random random(11);
  for (int round = 0; round < 1000; ++round) {
    const Case c = random_case(random);
    std::uint64_t compared = 0, differing = 0;
    std::uint32_t largest = 0;
    PixelPosition first;
    int left = c.reference.width, top = c.reference.height, right = -1, bottom = -1;
    for (int y = 0; y < c.reference.height; ++y) {
      for (int x = 0; x < c.reference.width; ++x) {
        compared += c.selection.compares(x, y) ? 1u : 0u;
        const std::uint32_t steps = steps_at(c, x, y);
        if (steps == 0) continue;
        if (differing++ == 0) first = {x, y};
        largest = std::max(largest, steps);
        left = std::min(left, x), right = std::max(right, x);
        top = std::min(top, y), bottom = std::max(bottom, y);
      }
    }
    INFO("seed 11, round " << round << ": " << c.reference.width << " x " << c.reference.height
                           << ", " << c.reference.channels << " channels of " << name_of(c.format));
    const Differences found = find_differences(c.pair());
    REQUIRE(found.compared == compared);
    REQUIRE(found.differing == differing);
    REQUIRE(found.largest == largest);
    std::uint64_t in_regions = 0;
    for (const Region& region : find_differences(c.pair(), nullptr, 2000).regions) {
      in_regions += region.pixels;
    }
    REQUIRE(in_regions == differing);
    REQUIRE(found.regions.size() == std::min<std::uint64_t>(found.region_count, 100));
    if (differing == 0) continue;
    REQUIRE(found.first == first);
    REQUIRE(found.box == PixelBox{left, top, right - left + 1, bottom - top + 1});
    REQUIRE(found.regions.front().largest == largest);
  }
}

TEST_CASE("the steps of a row are those of its pixels, and a row without steps is known") {
  Random random(12);
  for (int round = 0; round < 500; ++round) {
    const Case c = random_case(random);
    for (int y = 0; y < c.reference.height; ++y) {
      // The row is filled first, to see that every element is written.
      std::vector<std::uint32_t> steps(std::size_t(c.reference.width), 12345u);
      const bool may_differ = row_differences(c.pair(), y, steps);
      std::vector<std::uint32_t> expected;
      for (int x = 0; x < c.reference.width; ++x) expected.push_back(steps_at(c, x, y));
      INFO("seed 12, round " << round << ", row " << y);
      REQUIRE(steps == expected);
      const bool differs =
          std::any_of(steps.begin(), steps.end(), [](std::uint32_t step) { return step > 0; });
      REQUIRE((may_differ || !differs));
    }
  }
}

TEST_CASE("rows of the same bytes are known to be the same, unless NaN is among them") {
  StoredImage image = blank(5, 2, 3, Format::kFloats);
  set_sample(image, 4, 1, 2, std::nan(""));
  const StoredImage copy = image;
  const Selection all(5, 2);
  std::vector<std::uint32_t> steps(5);
  CHECK(!row_differences({image, copy, all, false}, 0, steps));
  CHECK(row_differences({image, copy, all, false}, 1, steps));
  CHECK(steps[4] == kUnbounded);
  CHECK(!row_differences({image, copy, all, true}, 1, steps));
}

TEST_CASE("one step in one sample is found wherever it is") {
  for (const Format format : kFormats) {
    for (int channels = 1; channels <= 4; ++channels) {
      const StoredImage reference = blank(7, 5, channels, format);
      const Selection all(7, 5);
      const double step = format == Format::kFloats ? double(0x1p-149f) : 1;
      for (int y = 0; y < 5; ++y) {
        for (int x = 0; x < 7; ++x) {
          for (int c = 0; c < channels; ++c) {
            StoredImage test = reference;
            set_sample(test, x, y, c, step);
            const Differences found = find_differences({reference, test, all});
            INFO(name_of(format) << ", channel " << c << " of " << channels << ", pixel (" << x
                                 << ", " << y << ")");
            REQUIRE(found.differing == 1);
            REQUIRE(found.largest == 1);
            REQUIRE(found.first == PixelPosition{x, y});
            REQUIRE(found.box == PixelBox{x, y, 1, 1});
            REQUIRE(found.region_count == 1);
          }
        }
      }
    }
  }
}

TEST_CASE("the full range of a format is counted in its own steps") {
  const Selection all(1, 1);
  const auto largest = [&](Format format, double from, double to) {
    StoredImage reference = blank(1, 1, 1, format), test = reference;
    set_sample(reference, 0, 0, 0, from);
    set_sample(test, 0, 0, 0, to);
    return find_differences({reference, test, all}).largest;
  };
  CHECK(largest(Format::kBytes, 0, 255) == 255);
  CHECK(largest(Format::kBytes, 255, 0) == 255);
  CHECK(largest(Format::kShorts, 0, 65535) == 65535);
  CHECK(largest(Format::kShorts, 65535, 0) == 65535);
  CHECK(largest(Format::kFloats, 1, 2) == 1u << 23);
  CHECK(largest(Format::kFloats, -1, 1) == 2u * 0x3f800000u + 1);
}

}  // namespace
}  // namespace glassbox::test
