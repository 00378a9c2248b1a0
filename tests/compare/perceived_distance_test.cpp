// Tests the distance of two colours against values of its definition, and the threshold on it.
#include "tests/support/catch.h"

#include <cmath>
#include <limits>
#include <vector>

#include "tests/compare/pictures.h"

#include <glassbox/base/random.h>
#include <glassbox/compare/pixels/heat_map.h>
#include <glassbox/compare/pixels/perceived_distance.h>

namespace glassbox::test {
namespace {

StoredImage pixel(const std::vector<double>& samples, Format format = Format::kBytes) {
  StoredImage image = blank(1, 1, int(samples.size()), format);
  for (int c = 0; c < image.channels; ++c) set_sample(image, 0, 0, c, samples[std::size_t(c)]);
  return image;
}

double distance_between(const StoredImage& a, const StoredImage& b) {
  const Selection all(1, 1);
  return perceived_distance({a, b, all}, {0, 0});
}

double distance_of(const std::vector<double>& a, const std::vector<double>& b) {
  return distance_between(pixel(a), pixel(b));
}

TEST_CASE("the distance is 0 for a colour and itself, and near 1 for black and white") {
  CHECK(distance_of({1, 2, 3}, {1, 2, 3}) == 0);
  // Y of white is 255, I and Q are 0.
  CHECK(std::abs(distance_of({0, 0, 0}, {255, 255, 255}) - std::sqrt(0.5053 / 35215) * 255) < 1e-6);
}

TEST_CASE("a step of grey is 0.003788, so 26 steps are within 0.1, and 27 are not") {
  CHECK(distance_of({100, 100, 100}, {126, 126, 126}) < 0.1);
  CHECK(distance_of({100, 100, 100}, {127, 127, 127}) > 0.1);
  CHECK(distance_of({100}, {126}) == distance_of({100, 100, 100}, {126, 126, 126}));
}

TEST_CASE("the farthest colours are at most 1 apart, and the bound is tight") {
  double farthest = 0;
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 8; ++j) {
      const auto corner = [](int bits) {
        return std::vector<double>{bits & 1 ? 255. : 0., bits & 2 ? 255. : 0.,
                                   bits & 4 ? 255. : 0.};
      };
      farthest = std::max(farthest, distance_of(corner(i), corner(j)));
    }
  }
  CHECK(farthest <= 1);
  CHECK(farthest > 0.9999);
}

TEST_CASE("the distance is symmetric, and 16 bits are bytes with fractions") {
  Random random(71);
  for (int round = 0; round < 200; ++round) {
    std::vector<double> a, b, wide_a, wide_b;
    for (int c = 0; c < 4; ++c) {
      a.push_back(double(random.integer(0, 255)));
      b.push_back(double(random.integer(0, 255)));
      wide_a.push_back(a.back() * 257);
      wide_b.push_back(b.back() * 257);
    }
    CHECK(distance_of(a, b) == distance_of(b, a));
    CHECK(
        std::abs(distance_between(pixel(wide_a, Format::kShorts), pixel(wide_b, Format::kShorts)) -
                 distance_of(a, b)) < 1e-12);
  }
}

TEST_CASE("what is transparent is seen over black and over white") {
  CHECK(distance_of({10, 200, 30, 0}, {90, 0, 255, 0}) == 0);
  // Black that becomes transparent is seen over white, white over black.
  CHECK(distance_of({0, 0, 0, 255}, {0, 0, 0, 0}) == distance_of({0, 0, 0}, {255, 255, 255}));
  CHECK(distance_of({255, 255, 255, 255}, {255, 255, 255, 0}) ==
        distance_of({0, 0, 0}, {255, 255, 255}));
}

TEST_CASE("floats have no distance") {
  CHECK(
      std::isinf(distance_between(pixel({0.5}, Format::kFloats), pixel({0.25}, Format::kFloats))));
}

TEST_CASE("pixels within the threshold are counted apart, and drawn in their own colour") {
  StoredImage reference = blank(5, 1, 3, Format::kBytes), test = reference;
  const double greens[] = {0, 2, 20, 100, 200};
  for (int x = 0; x < 5; ++x) set_sample(test, x, 0, 1, greens[x]);
  const Selection all(5, 1);
  const double middle = (perceived_distance({reference, test, all}, {2, 0}) +
                         perceived_distance({reference, test, all}, {3, 0})) /
                        2;
  const PicturePair pair{reference, test, all, false, {middle, false}};
  const Differences found = find_differences(pair);
  CHECK(found.differing == 2);
  CHECK(found.largest == 200);
  CHECK(found.first == PixelPosition{3, 0});
  CHECK(found.region_count == 1);
  CHECK(found.below_threshold.pixels == 2);
  CHECK(found.below_threshold.largest == 20);
  CHECK(found.moved_edges.pixels == 0);
  const Image<std::uint8_t> levels = heat_map(pair);
  CHECK(levels.at(0, 0) == kHeatSame);
  CHECK(levels.at(1, 0) == kHeatBelowThreshold);
  CHECK(levels.at(2, 0) == kHeatBelowThreshold);
  CHECK(is_heat(levels.at(3, 0)));
  CHECK(largest_distance(pair) == perceived_distance(pair, {4, 0}));
  // A threshold that is the distance itself allows it.
  const PicturePair exact{reference, test, all, false, {largest_distance(pair), false}};
  CHECK(find_differences(exact).differing == 0);
}

}  // namespace
}  // namespace glassbox::test
