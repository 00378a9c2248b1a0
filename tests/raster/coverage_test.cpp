// Coverage, compared with brute force in 128-bit integers.
#include <algorithm>
#include <set>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/raster/coverage.h>

#include "tests/raster/exact.h"
#include "tests/support/catch.h"

namespace {

using namespace glassbox;
using namespace glassbox::test;

using Pixels = std::vector<std::array<int, 2>>;  // x, y

// The pixels that for_each_covered visits, in its order.
Pixels covered(const SnappedTriangle& triangle, const PixelRect& window) {
  Pixels pixels;
  if (const auto setup = setup_triangle(screen_triangle(triangle))) {
    for_each_covered(*setup, window, [&](const Coverage& c) { pixels.push_back({c.x, c.y}); });
  }
  return pixels;
}

Pixels exactly_covered(const SnappedTriangle& triangle, const PixelRect& window) {
  Pixels pixels;
  for (int y = window.y0; y < window.y1; ++y) {
    for (int x = window.x0; x < window.x1; ++x) {
      if (covers_exactly(triangle, x, y)) pixels.push_back({x, y});
    }
  }
  return pixels;
}

void require_exact(const SnappedTriangle& triangle, const PixelRect& window) {
  const Pixels found = covered(triangle, window);
  const Pixels expected = exactly_covered(triangle, window);
  if (found == expected) return;  // the same pixels in the same order, row by row
  CAPTURE(triangle, window.x0, window.y0, window.x1, window.y1, expected.size(), found.size());
  REQUIRE(found == expected);
}

SnappedVertex near_window(Random& random, const PixelRect& w, int margin_px) {
  return {std::int32_t(random.integer((w.x0 - margin_px) * 256, (w.x1 + margin_px) * 256)),
          std::int32_t(random.integer((w.y0 - margin_px) * 256, (w.y1 + margin_px) * 256))};
}

SnappedVertex on_lattice(const SnappedVertex& v, int step, int offset) {
  const auto round = [&](std::int32_t x) { return (x & ~(step - 1)) + offset; };
  return {round(v.x), round(v.y)};
}

enum Kind { kAnywhere, kTiny, kSliver, kHuge, kCentres, kCorners, kFlat, kKinds };

SnappedTriangle random_triangle(Random& random, Kind kind, const PixelRect& window) {
  SnappedTriangle t;
  for (SnappedVertex& v : t) v = near_window(random, window, kind == kAnywhere ? 8 : 0);
  const auto nudge = [&](std::int32_t most) { return std::int32_t(random.integer(-most, most)); };
  switch (kind) {
    case kTiny:  // within a pixel
      for (std::size_t k : {1u, 2u}) t[k] = {t[0].x + nudge(200), t[0].y + nudge(200)};
      break;
    case kSliver:  // up to 4000 px long, a few 1/256 px wide
      t[1] = {t[0].x + nudge(4), t[0].y + nudge(4)};
      t[2] = {t[0].x + nudge(1024000), t[0].y + nudge(1024000)};
      break;
    case kHuge:  // out to the guard band, with one vertex near
      for (std::size_t k : {1u, 2u}) t[k] = {nudge(1 << 23), nudge(1 << 23)};
      break;
    case kCentres:
      for (SnappedVertex& v : t) v = on_lattice(v, 256, 128);
      break;
    case kCorners:
      for (SnappedVertex& v : t) v = on_lattice(v, random.integer(0, 1) == 0 ? 256 : 64, 0);
      break;
    case kFlat: {  // the third vertex is at most 1/256 px from the line through the others
      const std::int32_t n = std::int32_t(random.integer(-3, 3));
      t[2] = {t[0].x + n * (t[1].x - t[0].x), t[0].y + n * (t[1].y - t[0].y) + nudge(1)};
      break;
    }
    default:
      break;
  }
  return t;
}

}  // namespace

TEST_CASE(
    "a triangle covers exactly the pixels that the top-left rule gives it (C-43, C-47, C-48, C-50, "
    "C-51)") {
  const std::uint64_t seed = 43;
  INFO("seed " << seed);
  Random random(seed);
  const std::array<PixelRect, 4> windows{PixelRect{0, 0, 9, 9}, PixelRect{-5, -6, 4, 3},
                                         PixelRect{7671, 4311, 7680, 4320},
                                         PixelRect{32760, -32768, 32768, -32760}};
  for (int i = 0; i < 105000; ++i) {
    const PixelRect& window = windows[std::size_t(random.integer(0, 3))];
    SnappedTriangle t = random_triangle(random, Kind(i % kKinds), window);
    require_exact(t, window);
  }
}

TEST_CASE("coverage does not depend on winding or on where the vertices start (C-51)") {
  Random random(51);
  const PixelRect window{0, 0, 12, 12};
  for (int i = 0; i < 4000; ++i) {
    SnappedTriangle t = random_triangle(random, Kind(i % kKinds), window);
    const Pixels once = covered(t, window);
    const auto setup = setup_triangle(screen_triangle(t));
    CAPTURE(t);
    REQUIRE(covered({t[1], t[2], t[0]}, window) == once);
    REQUIRE(covered({t[0], t[2], t[1]}, window) == once);
    if (!setup) continue;
    REQUIRE(setup_triangle(screen_triangle({t[1], t[2], t[0]}))->clockwise == setup->clockwise);
    REQUIRE(setup_triangle(screen_triangle({t[0], t[2], t[1]}))->clockwise != setup->clockwise);
  }
}

TEST_CASE(
    "the edge functions of a covered pixel are exact, sum to the area and name their vertex") {
  Random random(3);
  const PixelRect window{-4, -4, 8, 8};
  for (int i = 0; i < 4000; ++i) {
    const SnappedTriangle t = random_triangle(random, Kind(i % kKinds), window);
    const auto setup = setup_triangle(screen_triangle(t));
    if (!setup) continue;
    CAPTURE(t);
    for_each_covered(*setup, window, [&](const Coverage& c) {
      REQUIRE(c.edges[0] + c.edges[1] + c.edges[2] == setup->double_area);
      for (std::size_t k = 0; k < 3; ++k) {
        const SnappedVertex& from = t[std::size_t(setup->order[(k + 1) % 3])];
        const SnappedVertex& to = t[std::size_t(setup->order[(k + 2) % 3])];
        REQUIRE(Int128(c.edges[k]) == cross_at(from, to, c.x, c.y));
      }
    });
  }
}

TEST_CASE("Microsoft's published pair of triangles covers 15 and 10 pixels (C-43)") {
  // The document (about Direct3D 9) has pixel centres at integers; here they are at halves.
  const auto at = [](int x, int y) { return SnappedVertex{x * 256 + 128, y * 256 + 128}; };
  const PixelRect window{-2, -2, 9, 9};
  const Pixels upper = covered({at(0, 0), at(5, 0), at(5, 5)}, window);
  const Pixels lower = covered({at(0, 5), at(0, 0), at(5, 5)}, window);
  CHECK(upper.size() == 15);
  CHECK(lower.size() == 10);
  std::set<std::array<int, 2>> both(upper.begin(), upper.end());
  both.insert(lower.begin(), lower.end());
  CHECK(both.size() == 25);
  for (const auto& p : both) CHECK((p[0] >= 0 && p[0] < 5 && p[1] >= 0 && p[1] < 5));
}

TEST_CASE("Microsoft's rectangle (1,1)-(3,5) covers 2 by 4 pixels (C-43)") {
  const auto at = [](int x, int y) { return SnappedVertex{x * 256 + 128, y * 256 + 128}; };
  const PixelRect window{-2, -2, 9, 9};
  Pixels pixels = covered({at(1, 1), at(3, 1), at(3, 5)}, window);
  const Pixels rest = covered({at(1, 1), at(3, 5), at(1, 5)}, window);
  pixels.insert(pixels.end(), rest.begin(), rest.end());
  std::sort(pixels.begin(), pixels.end());
  REQUIRE(pixels == Pixels{{1, 1}, {1, 2}, {1, 3}, {1, 4}, {2, 1}, {2, 2}, {2, 3}, {2, 4}});
}

TEST_CASE("a triangle that snapping flattens covers nothing and is not set up (C-49)") {
  // Three points that are not collinear until they are rounded to 1/256 px.
  const std::array<ScreenVertex, 3> thin{ScreenVertex{{10.0f, 10.0f, 0.5f}, 1},
                                         ScreenVertex{{20.0f, 10.001f, 0.5f}, 1},
                                         ScreenVertex{{30.0f, 9.999f, 0.5f}, 1}};
  REQUIRE(!setup_triangle(thin));
  REQUIRE(!setup_triangle(screen_triangle({SnappedVertex{5, 5}, {5, 5}, {900, 3}})));
  REQUIRE(!setup_triangle(screen_triangle({SnappedVertex{5, 5}, {5, 5}, {5, 5}})));
  REQUIRE(!setup_triangle(
      screen_triangle({SnappedVertex{-8388608, -8388608}, {0, 0}, {8388608, 8388608}})));
  REQUIRE(setup_triangle(
      screen_triangle({SnappedVertex{-8388608, -8388608}, {0, 1}, {8388608, 8388608}})));
}

TEST_CASE("a triangle that fills the guard band covers every pixel of any window once (C-50)") {
  const SnappedTriangle t{
      SnappedVertex{-8388608, -8388608}, {3 * 8388608 / 2, -8388608}, {-8388608, 3 * 8388608 / 2}};
  const PixelRect window{0, 0, 50, 40};
  REQUIRE(covered(t, window).size() == 2000);
  require_exact(t, window);
}

TEST_CASE("a window beside the triangle, or an empty one, sees no pixel") {
  const SnappedTriangle t{SnappedVertex{0, 0}, {2560, 0}, {0, 2560}};
  REQUIRE(covered(t, {20, 20, 30, 30}).empty());
  REQUIRE(covered(t, {-30, 0, -20, 10}).empty());
  REQUIRE(covered(t, {3, 3, 3, 9}).empty());
  REQUIRE(intersect({0, 0, 5, 5}, {5, 0, 9, 5}).empty());
}
