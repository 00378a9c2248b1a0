#include "tests/support/catch.h"

#include <limits>

#include <glassbox/images/stereo/visible_depth.h>

namespace {

using namespace glassbox;

// Two test pictures: thin trunks every `period` pixels, which have many vertical edges, and a road,
// which has none.
Image<Rgba8> trunks(int period) {
  Image<Rgba8> picture(60, 10, {150, 170, 200, 255});
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; x += period) picture.at(x, y) = {60, 40, 20, 255};
  }
  return picture;
}

Image<Rgba8> road() {
  Image<Rgba8> picture(60, 10);
  for (int y = 0; y < picture.height; ++y) {
    const auto level = std::uint8_t(80 + 10 * y);
    for (int x = 0; x < picture.width; ++x) picture.at(x, y) = {level, level, level, 255};
  }
  return picture;
}

}  // namespace

TEST_CASE("a forest of thin trees scores above a flat road (S0-16)") {
  const Image<float> depth(60, 10, 3.0f);
  const auto forest = stereo_information(trunks(6), depth);
  const auto flat = stereo_information(road(), depth);
  REQUIRE((forest && flat));
  CHECK(forest->score > 0);
  CHECK(flat->score == 0);
  CHECK(flat->displaced == flat->pixels);
}

// Edges are at both neighbours of each trunk at x = 6, 12, ... 54, and at the right neighbour of
// the trunk at 0.
TEST_CASE("the score counts edges that are displaced, and only those with a disparity") {
  Image<float> disparity(60, 10, 1.0f);
  auto found = stereo_information(trunks(6), disparity);
  REQUIRE(found);
  CHECK(found->pixels == 58 * 10);
  CHECK(found->edges == (2 * 9 + 1) * 10);
  CHECK(found->score == found->edges);
  CHECK(found->share == 190.0 / 600);

  for (int y = 0; y < 10; ++y) {
    disparity.at(5, y) = 0.5f;   // not an edge with depth: it must exceed half a pixel
    disparity.at(7, y) = -0.6f;  // exceeds half a pixel
    disparity.at(11, y) = std::numeric_limits<float>::quiet_NaN();
    disparity.at(13, y) = std::numeric_limits<float>::infinity();
  }
  found = stereo_information(trunks(6), disparity);
  REQUIRE(found);
  CHECK(found->pixels == 56 * 10);
  CHECK(found->edges == 17 * 10);
  CHECK(found->displaced == 55 * 10);
  CHECK(found->score == 16 * 10);
}

TEST_CASE("an edge is steeper than the limit, in bytes of luma a pixel") {
  Image<Rgba8> step(3, 1, {100, 100, 100, 255});
  step.at(2, 0) = {108, 108, 108, 255};  // half the difference of its neighbours is exactly 4
  const Image<float> disparity(3, 1, 2.0f);
  CHECK(stereo_information(step, disparity)->score == 0);
  CHECK(stereo_information(step, disparity, {3.999, 0.5})->score == 1);
  step.at(2, 0) = {109, 108, 108, 255};
  CHECK(stereo_information(step, disparity)->score == 1);
}

TEST_CASE("stereo information refuses maps of another size and limits that are none") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(stereo_information({3, 3}, {3, 2}));
  CHECK_FALSE(stereo_information({3, 3}, {3, 3}, {nan, 0.5}));
  CHECK_FALSE(stereo_information({3, 3}, {3, 3}, {4, -1}));
  CHECK(stereo_information({}, {})->share == 0);
  CHECK(stereo_information({1, 5}, {1, 5})->pixels == 0);
}
