// The rasterization of lines and points, compared with brute force.
#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/raster/line.h>
#include <glassbox/raster/point.h>

#include "tests/raster/exact.h"
#include "tests/support/catch.h"

namespace {

using namespace glassbox;
using namespace glassbox::test;

using Pixels = std::vector<std::array<int, 2>>;  // x, y

Pixels drawn(const SnappedVertex& a, const SnappedVertex& b, const PixelRect& window) {
  Pixels pixels;
  for_each_line_pixel(a, b, window, [&](const LinePixel& p) {
    if (p.step < 0 || p.step > p.steps || p.steps <= 0)
      FAIL("step " << p.step << " of " << p.steps);
    pixels.push_back({p.x, p.y});
  });
  std::sort(pixels.begin(), pixels.end());
  return pixels;
}

// ---- the diamond-exit rule as it is written ----
//
// The line is moved by (-e, +e^2) with e = 2^-20 of 1/256 px, in units of 2^-40 of 1/256 px. For
// lines shorter than 2^12 / 256 px this decides as an infinitely small e does. The compared numbers
// are multiples of 1/d, where d is dx or dy, so they are equal or at least 1/d apart, and the move
// changes them by at most e (1 + 2^12 / d), which is far less. If they are equal, the slope m
// enters by m e + e^2; m is 0 or at least 2^-12, so m e is at least 2^8 times e^2.
struct Moved {
  Int128 x, y;
};

Moved moved(const SnappedVertex& p) {
  const Int128 unit = Int128(1) << 40;
  return {p.x * unit - (Int128(1) << 20), p.y * unit + 1};
}

Int128 size_of(Int128 n) {
  return n < 0 ? -n : n;
}

// Whether |x| + |y| < 1/2 px somewhere between p and q, which are relative to the diamond's centre.
// The sum is convex and piecewise linear: it is smallest at an end or where x or y is 0.
bool meets_diamond(const Moved& p, const Moved& q) {
  const Int128 half = Int128(128) << 40;
  if (size_of(p.x) + size_of(p.y) < half || size_of(q.x) + size_of(q.y) < half) return true;
  if ((p.x < 0) != (q.x < 0) &&
      size_of(p.y * (q.x - p.x) - p.x * (q.y - p.y)) < half * size_of(q.x - p.x)) {
    return true;
  }
  return (p.y < 0) != (q.y < 0) &&
         size_of(p.x * (q.y - p.y) - p.y * (q.x - p.x)) < half * size_of(q.y - p.y);
}

Pixels exactly_drawn(const SnappedVertex& a, const SnappedVertex& b, const PixelRect& window) {
  Pixels pixels;
  if (a == b) return pixels;
  const Moved from = moved(a), to = moved(b);
  const Int128 half = Int128(128) << 40;
  for (int x = window.x0; x < window.x1; ++x) {
    for (int y = window.y0; y < window.y1; ++y) {
      const Int128 cx = (Int128(x) * 256 + 128) << 40, cy = (Int128(y) * 256 + 128) << 40;
      const Moved p{from.x - cx, from.y - cy}, q{to.x - cx, to.y - cy};
      const bool ends_inside = size_of(q.x) + size_of(q.y) < half;
      if (!ends_inside && meets_diamond(p, q)) pixels.push_back({x, y});
    }
  }
  return pixels;
}

SnappedVertex at_centre(int x, int y) {
  return {x * 256 + 128, y * 256 + 128};
}

}  // namespace

TEST_CASE(
    "a line draws exactly the diamonds that it leaves: 10^5 short lines of all kinds (C-55)") {
  const std::uint64_t seed = 55;
  INFO("seed " << seed);
  Random random(seed);
  for (int i = 0; i < 100000; ++i) {
    const int x = int(random.integer(-3, 3)), y = int(random.integer(-3, 3));
    const PixelRect window{x - 1, y - 1, x + 5, y + 5};
    // Points anywhere; on centres, corners and middles of edges; on borders of diamonds; with one
    // coordinate of a centre.
    const std::int32_t grids[] = {1, 128, 64, 32};
    const std::int32_t grid = grids[i % 4];
    const int length = i % 8 < 4 ? 1024 : 300;
    const auto coordinate = [&](int pixel, std::int32_t step) {
      return std::int32_t(random.integer(pixel * 256, pixel * 256 + length)) / step * step;
    };
    SnappedVertex a{coordinate(x, grid), coordinate(y, grid)};
    SnappedVertex b{coordinate(x, grid), coordinate(y, i % 3 == 0 ? 1 : grid)};
    if (i % 16 == 5) b.y = a.y;
    if (i % 16 == 6) b.x = a.x;
    if (i % 16 == 7) b = {a.x + (b.y - a.y), b.y};  // at 45 degrees
    const Pixels found = drawn(a, b, window), expected = exactly_drawn(a, b, window);
    if (found == expected) continue;
    CAPTURE(i, a.x, a.y, b.x, b.y);
    REQUIRE(found == expected);
  }
}

TEST_CASE("a line from centre to centre draws its first pixel and not its last (C-55)") {
  const PixelRect window{-9, -9, 20, 20};
  CHECK(drawn(at_centre(0, 0), at_centre(4, 0), window) == Pixels{{0, 0}, {1, 0}, {2, 0}, {3, 0}});
  CHECK(drawn(at_centre(4, 0), at_centre(0, 0), window) == Pixels{{1, 0}, {2, 0}, {3, 0}, {4, 0}});
  CHECK(drawn(at_centre(0, 0), at_centre(0, 3), window) == Pixels{{0, 0}, {0, 1}, {0, 2}});
  CHECK(drawn(at_centre(0, 3), at_centre(0, 0), window) == Pixels{{0, 1}, {0, 2}, {0, 3}});
  CHECK(drawn(at_centre(0, 0), at_centre(3, 3), window) == Pixels{{0, 0}, {1, 1}, {2, 2}});
  CHECK(drawn(at_centre(3, 0), at_centre(0, 3), window) == Pixels{{1, 2}, {2, 1}, {3, 0}});
  CHECK(drawn(at_centre(2, 2), at_centre(2, 2), window).empty());
  // Nothing is drawn inside one diamond.
  CHECK(drawn({128, 128}, {180, 140}, window).empty());
}

TEST_CASE("a line exactly between two rows is drawn in one, between two columns in one (C-55)") {
  const PixelRect window{-9, -9, 20, 20};
  CHECK(drawn({128, 256}, {1152, 256}, window) == Pixels{{0, 1}, {1, 1}, {2, 1}, {3, 1}});
  CHECK(drawn({1152, 256}, {128, 256}, window) == Pixels{{0, 1}, {1, 1}, {2, 1}, {3, 1}});
  CHECK(drawn({256, 128}, {256, 1152}, window).size() == 4);
  for (const auto& pixel : drawn({256, 128}, {256, 1152}, window)) CHECK(pixel[0] == 0);
}

TEST_CASE(
    "lines that go on in the same direction draw no pixel of a joint twice and leave none out "
    "(C-55)") {
  Random random(12);
  const PixelRect window{0, 0, 64, 64};
  for (int i = 0; i < 4000; ++i) {
    // Mostly to the right, left, down or up: at less than 45 degrees to that axis.
    const bool x_major = i % 2 == 0;
    const std::int32_t sign = i % 4 < 2 ? 1 : -1;
    const std::int32_t grid = i % 3 == 0 ? 64 : 1;
    std::int32_t major = sign > 0 ? 700 : 15000, minor = 8000;
    const auto vertex = [&] {
      return x_major ? SnappedVertex{major, minor} : SnappedVertex{minor, major};
    };
    SnappedVertex last = vertex();
    std::set<std::array<int, 2>> pixels;
    std::set<int> majors;
    std::size_t count = 0;
    for (int part = 0; part < 12; ++part) {
      const auto run = std::int32_t(random.integer(0, 900)) / grid * grid;
      const auto rise = std::int32_t(random.integer(-run, run)) / grid * grid;
      if (std::abs(rise) == run) continue;  // a line at 45 degrees belongs to both directions
      major += sign * run;
      minor += rise;
      for (const auto& pixel : drawn(last, vertex(), window)) {
        pixels.insert(pixel);
        majors.insert(pixel[x_major ? 0 : 1]);
        ++count;
      }
      last = vertex();
    }
    CAPTURE(i);
    REQUIRE(count == pixels.size());
    REQUIRE(majors.size() == pixels.size());  // one pixel in each column or row
    if (!majors.empty()) REQUIRE(*majors.rbegin() - *majors.begin() + 1 == int(majors.size()));
  }
}

TEST_CASE(
    "lines out to the guard band pass every column or row of the window once, in the nearest pixel "
    "(C-50, C-55)") {
  Random random(13);
  const PixelRect window{100, 200, 164, 264};
  int pixels = 0;
  for (int i = 0; i < 3000; ++i) {
    // Through a point of the window, and far out on both sides.
    const std::int32_t px = std::int32_t(random.integer(100 * 256, 164 * 256));
    const std::int32_t py = std::int32_t(random.integer(200 * 256, 264 * 256));
    const std::int32_t dx = std::int32_t(random.integer(-(1 << 23), 1 << 23));
    const std::int32_t dy = std::int32_t(random.integer(-(1 << 23), 1 << 23));
    const SnappedVertex a{px - dx, py - dy}, b{px + dx, py + dy + int(random.integer(-9, 9))};
    const bool x_major = std::abs(b.x - a.x) >= std::abs(b.y - a.y);
    std::set<int> seen;
    for (const auto& pixel : drawn(a, b, window)) {
      ++pixels;
      REQUIRE(seen.insert(pixel[x_major ? 0 : 1]).second);
      // The centre's distance from the line, across its major axis, is at most 1/2 px.
      const Int128 across = x_major ? b.x - a.x : b.y - a.y;
      REQUIRE(size_of(cross_at(a, b, pixel[0], pixel[1])) <= 128 * size_of(across));
    }
    for (int k = 0; k < 64; ++k) {  // there is a pixel wherever the line passes inside the window
      const int major = x_major ? 100 + k : 200 + k;
      const double centre = major * 256 + 128;
      const double minor = x_major ? a.y + (centre - a.x) / double(b.x - a.x) * double(b.y - a.y)
                                   : a.x + (centre - a.y) / double(b.y - a.y) * double(b.x - a.x);
      const double low = (x_major ? 200 : 100) * 256;
      if (minor > low + 1 && minor < low + 64 * 256 - 1) REQUIRE(seen.count(major) == 1);
    }
  }
  REQUIRE(pixels > 10000);
}

TEST_CASE("a window cuts a line's pixels and changes none") {
  Random random(14);
  for (int i = 0; i < 2000; ++i) {
    const auto vertex = [&] {
      return SnappedVertex{std::int32_t(random.integer(-2000, 4000)),
                           std::int32_t(random.integer(-2000, 4000))};
    };
    const SnappedVertex a = vertex(), b = vertex();
    const PixelRect cut{2, 3, 7, 9};
    Pixels expected;
    for (const auto& p : drawn(a, b, {-50, -50, 50, 50})) {
      if (p[0] >= cut.x0 && p[0] < cut.x1 && p[1] >= cut.y0 && p[1] < cut.y1) expected.push_back(p);
    }
    REQUIRE(drawn(a, b, cut) == expected);
  }
}

TEST_CASE("steps along a line follow the pixel's centre, from the first end to the second") {
  for_each_line_pixel(at_centre(1, 1), at_centre(9, 3), {0, 0, 20, 20}, [](const LinePixel& p) {
    CHECK(p.steps == 8 * 256);
    CHECK(p.step == (p.x - 1) * 256);
  });
  for_each_line_pixel(at_centre(3, 9), at_centre(1, 1), {0, 0, 20, 20}, [](const LinePixel& p) {
    CHECK(p.steps == 8 * 256);
    CHECK(p.step == (9 - p.y) * 256);
  });
  // The line only leaves the pixel, from a start beyond its centre: the centre is before the line,
  // and the step is clamped.
  for_each_line_pixel({140, 128}, {900, 128}, {0, 0, 1, 1},
                      [](const LinePixel& p) { CHECK(p.step == 0); });
}

TEST_CASE(
    "a point is the one pixel whose centre lies in its unit square, closed at the left and the top "
    "(C-55)") {
  for (std::int32_t x = -700; x <= 700; ++x) {
    const PointPixel pixel = point_pixel({x, 300 - x});
    const std::int32_t cx = pixel.x * 256 + 128, cy = pixel.y * 256 + 128;
    CAPTURE(x);
    REQUIRE((x - 128 <= cx && cx < x + 128));
    REQUIRE((300 - x - 128 <= cy && cy < 300 - x + 128));
  }
  CHECK(point_pixel({256, 256}).x == 0);
  CHECK(point_pixel({257, 0}).x == 1);
  CHECK(point_pixel({257, 0}).y == -1);
}
