#include <glassbox/raster/fan.h>

#include <algorithm>
#include <array>
#include <vector>

#include <glassbox/base/random.h>
#include <tests/support/catch.h>

namespace glassbox {
namespace {

// How many triangles of the fan from `apex` are clockwise, and how many are counter-clockwise.
std::array<int, 2> turns(const std::vector<SnappedVertex>& polygon, int apex) {
  std::array<int, 2> count{};
  const int n = int(polygon.size());
  for (int i = 1; i + 1 < n; ++i) {
    const std::int64_t area =
        double_area(polygon[std::size_t(apex)], polygon[std::size_t((apex + i) % n)],
                    polygon[std::size_t((apex + i + 1) % n)]);
    count[0] += area > 0;
    count[1] += area < 0;
  }
  return count;
}

bool folds(const std::vector<SnappedVertex>& polygon, int apex) {
  const auto [clockwise, counter_clockwise] = turns(polygon, apex);
  return clockwise > 0 && counter_clockwise > 0;
}

TEST_CASE(
    "a quad that the snap bent inwards is cut from the bent corner, and 0 would fold (C-39)") {
  // Corner 1 is one step inside the diagonal from 0 to 2.
  const std::vector<SnappedVertex> quad{{0, 0}, {511, 513}, {1024, 1024}, {0, 1024}};
  CHECK(folds(quad, 0));
  CHECK(fan_apex(quad) == 1);
  CHECK_FALSE(folds(quad, 1));
}

TEST_CASE("a convex polygon is cut from its first vertex") {
  const std::vector<SnappedVertex> hexagon{{0, 0}, {10, -5}, {20, 0}, {20, 10}, {10, 15}, {0, 10}};
  CHECK(fan_apex(hexagon) == 0);
}

TEST_CASE("every quad without a crossing has an apex whose fan does not fold (C-39, C-49)") {
  constexpr std::uint64_t kSeed = 39;
  Random random(kSeed);
  int bent = 0;
  for (int trial = 0; trial < 100000; ++trial) {
    const auto coordinate = [&] { return std::int32_t(random.integer(-6, 6)); };
    std::vector<SnappedVertex> quad(4);
    for (SnappedVertex& vertex : quad) vertex = {coordinate(), coordinate()};
    // An outline with three corners that turn the same way is simple: one that crosses itself has
    // two of each.
    int clockwise = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      clockwise += double_area(quad[k], quad[(k + 1) % 4], quad[(k + 2) % 4]) > 0;
    }
    if (clockwise < 3) continue;
    INFO("seed " << kSeed << ", trial " << trial);
    bent += folds(quad, 0);
    CHECK_FALSE(folds(quad, fan_apex(quad)));
  }
  CHECK(bent > 1000);  // the test meets the case that it is about
}

}  // namespace
}  // namespace glassbox
