// Descriptors: what they do not change with, and that they are what their headers say.
#include <tests/support/catch.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/views/features/generated_pictures.h"
#include "views/features/bit_descriptor.h"
#include "views/features/gradient_descriptor.h"
#include "views/features/scale_level.h"
#include "views/features/window_descriptor.h"

namespace glassbox::views {
namespace {

using Eigen::Vector2d;

Image<float> pattern(std::uint64_t seed, int side) {
  const test::GreySquares squares(seed);
  return finest_level(test::drawn_picture(side, side, {}, seed,
                                          [&](const Vector2d& at) { return squares.at(at); }))
      .grey;
}

// The picture turned clockwise by a right angle: the pixel (x, y) goes to (side - 1 - y, x).
Image<float> turned(const Image<float>& grey) {
  Image<float> result(grey.height, grey.width);
  for (int y = 0; y < grey.height; ++y) {
    for (int x = 0; x < grey.width; ++x) result.at(grey.height - 1 - y, x) = grey.at(x, y);
  }
  return result;
}

double angle_between(double a, double b) {
  const double turn = 2 * kPi;
  const double difference = std::abs(a - b);
  const double rest = difference - turn * std::floor(difference / turn);
  return std::min(rest, turn - rest);
}

// Calls one(picture, turned picture, x, y, turned x, turned y) for places of generated pictures.
template <class One>
void for_turned_places(const One& one) {
  constexpr int kSide = 60;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    const Image<float> grey = pattern(seed, kSide), other = turned(grey);
    for (int i = 0; i < 10; ++i) {
      const double x = random.between(20, 40);
      const double y = random.between(20, 40);
      INFO("seed " << seed << ", place " << x << ", " << y);
      one(grey, other, Vector2d(x, y), Vector2d(kSide - y, x));
    }
  }
}

TEST_CASE("grey levels between four pixels are those of the bilinear function through them") {
  Image<float> grey(2, 2);
  grey.pixels = {1, 2, 5, 10};
  CHECK(grey_at(grey, 0.5, 0.5) == 1);
  CHECK(grey_at(grey, 1.5, 1.5) == 10);
  CHECK(grey_at(grey, 1, 0.5) == 1.5);
  CHECK(grey_at(grey, 0.75, 1.25) == 0.25 * (0.75 * 1 + 0.25 * 2) + 0.75 * (0.75 * 5 + 0.25 * 10));
  CHECK(grey_at(grey, -3, 9) == 5);
}

TEST_CASE("a coarser level shows the same at the same places") {
  // Smoothing changes a smooth function little: sin(x/20) by sigma^2/800, with sigma of 1.2 px.
  const auto smooth = [](const Vector2d& at) {
    return 0.5 + 0.4 * sin_cos(at.x() / 20).sin * sin_cos(at.y() / 25).cos;
  };
  ScaleLevel level = finest_level(test::drawn_picture(120, 100, {}, 0, smooth));
  for (int i = 0; i < 4; ++i) {
    level = coarser_level(level);
    CHECK(level.grey.width == int(120 / level.scale));
    for (int y = 4; y + 4 < level.grey.height; ++y) {
      for (int x = 4; x + 4 < level.grey.width; ++x) {
        const double truth = 255 * smooth(level.scale * Vector2d(x + 0.5, y + 0.5));
        // Half a grey level of rounding, before it is smoothed, and what the smoothing takes away.
        CHECK(std::abs(double(level.grey.at(x, y)) - truth) <
              0.5 + 102 * level.scale * level.scale * (1.0 / 800 + 1.0 / 1250));
      }
    }
  }
}

TEST_CASE(
    "a window does not change with gain and offset, and its distance is that of the formula") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    const Image<float> grey = pattern(seed, 40);
    Image<float> lit = grey;
    const double gain = random.between(0.3, 3);
    const double offset = random.between(-50, 50);
    for (float& value : lit.pixels) value = float(gain * double(value) + offset);
    const auto own = window_descriptor(grey, 18.3, 20.7);
    // A window's floats are rounded by at most 2^-24 of their size, so that c is off by some 2^-23,
    // and sqrt(2 - 2 c) by sqrt(2^-22) = 5e-4.
    CHECK(distance(own, window_descriptor(lit, 18.3, 20.7)) < 1e-3);
    const auto other = window_descriptor(grey, 24, 17);
    double correlation = 0;
    for (std::size_t i = 0; i < own.size(); ++i) correlation += double(own[i]) * double(other[i]);
    CHECK(std::abs(distance(own, other) - std::sqrt(2 - 2 * correlation)) < 1e-12);
    CHECK(distance(own, own) < 1e-3);
  }
  const auto nothing = window_descriptor(Image<float>(40, 40, 7.0f), 20, 20);
  CHECK(std::ranges::all_of(nothing, [](float value) { return value == 0; }));
}

TEST_CASE("the pattern of the bits is as its header says, and the same on every machine") {
  double squares = 0;
  std::uint64_t sum = 0;
  for (const auto& [x1, y1, x2, y2] : bit_pattern()) {
    CHECK(x1 * x1 + y1 * y1 <= kPatternRadius * kPatternRadius);
    CHECK(x2 * x2 + y2 * y2 <= kPatternRadius * kPatternRadius);
    CHECK((x2 - x1) * (x2 - x1) + (y2 - y1) * (y2 - y1) >= kLeastApart * kLeastApart);
    squares += x1 * x1 + y1 * y1 + x2 * x2 + y2 * y2;
    for (const double number : {x1, y1, x2, y2})
      sum = sum * 31 + std::uint64_t(std::int64_t(std::floor(number * 0x1p20)));
  }
  // 1024 numbers with the deviation 6.2 px, less what the circle cuts off.
  const double deviation = std::sqrt(squares / (4 * kDescriptorBits));
  CHECK(deviation > 5);
  CHECK(deviation < 6.2);
  CHECK(sum == 0xb593480aa5bd3cf3u);
}

TEST_CASE("bits turn with the picture") {
  int differing = 0;
  for_turned_places([&](const Image<float>& grey, const Image<float>& other, const Vector2d& at,
                        const Vector2d& place) {
    const double angle = centroid_angle(grey, at.x(), at.y());
    const double after = centroid_angle(other, place.x(), place.y());
    CHECK(angle_between(after, angle + kHalfPi) < 1e-6);
    const auto own = bit_descriptor(grey, at.x(), at.y(), angle);
    const auto bits = bit_descriptor(other, place.x(), place.y(), after);
    // Only two grey levels that are equal but for rounding may change their order.
    CHECK(distance(own, bits) <= 2);
    differing += distance(own, bit_descriptor(other, place.x(), place.y(), angle)) > 30;
  });
  CHECK(differing > 150);
}

TEST_CASE("histograms of gradients, and their directions, turn with the picture") {
  int differing = 0, second = 0;
  for_turned_places([&](const Image<float>& grey, const Image<float>& other, const Vector2d& at,
                        const Vector2d& place) {
    const auto angles = gradient_angles(grey, at.x(), at.y());
    const auto after = gradient_angles(other, place.x(), place.y());
    REQUIRE(!angles.empty());
    REQUIRE(angles.size() == after.size());
    second += angles.size() == 2;
    CHECK(angle_between(after[0], angles[0] + kHalfPi) < 1e-6);
    const auto own = gradient_descriptor(grey, at.x(), at.y(), angles[0]);
    const auto same = gradient_descriptor(other, place.x(), place.y(), after[0]);
    // Each of 128 numbers is rounded to a whole one.
    CHECK(distance(own, same) < std::sqrt(128.0));
    differing += distance(own, gradient_descriptor(other, place.x(), place.y(), angles[0])) > 100;
  });
  CHECK(differing > 150);
  CHECK(second > 5);
}

TEST_CASE("a descriptor of gradients has the length 512, and none of a flat picture") {
  const auto own = gradient_descriptor(pattern(3, 60), 30, 30, 1);
  double squares = 0;
  for (const auto value : own) squares += double(value) * double(value);
  CHECK(std::abs(std::sqrt(squares) - 512) < 10);
  const Image<float> flat(60, 60, 99.0f);
  CHECK(gradient_angles(flat, 30, 30) == std::vector{0.0});
  CHECK(std::ranges::all_of(gradient_descriptor(flat, 30, 30, 0), [](auto v) { return v == 0; }));
}

TEST_CASE("a ramp has one direction in every cell, and what is above 0.2 is cut off") {
  Image<float> ramp(60, 60);
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 60; ++x) ramp.at(x, y) = 3 * float(x);
  }
  const auto own = gradient_descriptor(ramp, 30, 30, 0);
  // By the Gaussian weights, the numbers of the four inner cells, the eight at the edges and the
  // four at the corners are about as 0.88, 0.53 and 0.32 under the root: 0.31, 0.24 and 0.19 of the
  // length. Cut off at 0.2, inner cells and edges are alike.
  const auto value = [&](int cell, int direction) {
    return int(own[std::size_t(cell * kDirections + direction)]);
  };
  for (int cell = 0; cell < kCells * kCells; ++cell) {
    const bool is_corner = cell == 0 || cell == 3 || cell == 12 || cell == 15;
    if (is_corner) {
      CHECK(value(cell, 0) < value(5, 0));
      CHECK(value(cell, 0) > value(5, 0) / 2);
    } else {
      CHECK(value(cell, 0) == value(5, 0));
    }
    for (int direction = 1; direction < kDirections; ++direction)
      CHECK(value(cell, direction) == 0);
  }
}

TEST_CASE("a gain and an offset change no bit, and no histogram by more than rounding") {
  const Image<float> grey = pattern(9, 60);
  Image<float> lit = grey;
  for (float& value : lit.pixels) value = 0.5f * value + 16;
  CHECK(bit_descriptor(grey, 30.2, 29.1, 0.7) == bit_descriptor(lit, 30.2, 29.1, 0.7));
  CHECK(distance(gradient_descriptor(grey, 30.2, 29.1, 0.7),
                 gradient_descriptor(lit, 30.2, 29.1, 0.7)) < 2);
}

}  // namespace
}  // namespace glassbox::views
