// Surfaces have no gaps, and no sample is drawn twice: every sample belongs to exactly one of the
// triangles that meet there.
//
// The same checks must find the faults of rasterizers that are wrong on purpose.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/raster/coverage.h>

#include "tests/raster/exact.h"
#include "tests/support/catch.h"

namespace {

using namespace glassbox;
using namespace glassbox::test;

// ---- the real rasterizer, and wrong ones ----

struct Real {
  template <class Visit>
  void operator()(const SnappedTriangle& t, const PixelRect& window, const Visit& visit) const {
    const auto setup = setup_triangle(screen_triangle(t));
    if (setup) for_each_covered(*setup, window, [&](const Coverage& c) { visit(c.x, c.y); });
  }
};

// Correct integer edge functions, but every edge owns the samples on it, or no edge does.
template <bool kOwn>
struct WithoutTieRule {
  template <class Visit>
  void operator()(const SnappedTriangle& t, const PixelRect& window, const Visit& visit) const {
    auto setup = setup_triangle(screen_triangle(t));
    if (!setup) return;
    for (EdgeFunction& edge : setup->edges) edge.owns_zero = kOwn;
    for_each_covered(*setup, window, [&](const Coverage& c) { visit(c.x, c.y); });
  }
};

// The top-left rule with edge functions of float differences, (b - a) x (p - a) from the first
// vertex of each edge.
struct FloatDifferences {
  template <class Visit>
  void operator()(const SnappedTriangle& t, const PixelRect& window, const Visit& visit) const {
    const auto setup = setup_triangle(screen_triangle(t));
    if (!setup) return;
    const PixelRect box = intersect(setup->bounds, window);
    for (int y = box.y0; y < box.y1; ++y) {
      for (int x = box.x0; x < box.x1; ++x) {
        bool inside = true;
        for (std::size_t k = 0; k < 3; ++k) {
          const SnappedVertex& a = t[std::size_t(setup->order[(k + 1) % 3])];
          const SnappedVertex& b = t[std::size_t(setup->order[(k + 2) % 3])];
          const float ax = float(a.x) / 256, ay = float(a.y) / 256;
          const float bx = float(b.x) / 256, by = float(b.y) / 256;
          const float e = (bx - ax) * (float(y) + 0.5f - ay) - (by - ay) * (float(x) + 0.5f - ax);
          inside = inside && (e > 0 || (e == 0 && setup->edges[k].owns_zero));
        }
        if (inside) visit(x, y);
      }
    }
  }
};

struct Faults {
  std::int64_t samples = 0, gaps = 0, doubles = 0;
};

// ---- shared edges ----

// (b - a) x (p - a) for the centre of pixel (x, y), in 64 bits, which suffice and are faster: the
// test computes millions of them.
std::int64_t cross_of(const SnappedVertex& a, const SnappedVertex& b, int x, int y) {
  return std::int64_t(b.x - a.x) * (y * 256 + 128 - a.y) -
         std::int64_t(b.y - a.y) * (x * 256 + 128 - a.x);
}

int side_of(const SnappedVertex& a, const SnappedVertex& b, const SnappedVertex& p) {
  const std::int64_t cross =
      std::int64_t(b.x - a.x) * (p.y - a.y) - std::int64_t(b.y - a.y) * (p.x - a.x);
  return (cross > 0) - (cross < 0);
}

bool strictly_inside(const SnappedTriangle& t, int x, int y) {
  const std::int64_t c0 = cross_of(t[0], t[1], x, y);
  const std::int64_t c1 = cross_of(t[1], t[2], x, y);
  const std::int64_t c2 = cross_of(t[2], t[0], x, y);
  return (c0 > 0 && c1 > 0 && c2 > 0) || (c0 < 0 && c1 < 0 && c2 < 0);
}

bool strictly_between(const SnappedVertex& a, const SnappedVertex& b, int x, int y) {
  if (cross_of(a, b, x, y) != 0) return false;
  const std::int64_t px = x * 256 + 128, py = y * 256 + 128;
  return (px - a.x) * (px - b.x) + (py - a.y) * (py - b.y) < 0;
}

// Draws the two triangles that share the edge a-b. Counts the samples of the window that are
// covered twice, and those inside either triangle or on the open edge that are not covered.
template <class Rasteriser>
void check_edge(const Rasteriser& rasterise, const SnappedTriangle& left,
                const SnappedTriangle& right, const PixelRect& window, Faults& faults) {
  std::array<int, 64> count{};
  const int width = window.x1 - window.x0;
  const auto at = [&](int x, int y) -> int& {
    return count[std::size_t((y - window.y0) * width + x - window.x0)];
  };
  const auto draw = [&](int x, int y) { ++at(x, y); };
  rasterise(left, window, draw);
  rasterise(right, window, draw);
  for (int y = window.y0; y < window.y1; ++y) {
    for (int x = window.x0; x < window.x1; ++x) {
      faults.samples += at(x, y) != 0;
      faults.doubles += at(x, y) > 1;
      faults.gaps += at(x, y) == 0 && (strictly_between(left[0], left[1], x, y) ||
                                       strictly_inside(left, x, y) || strictly_inside(right, x, y));
    }
  }
}

// Checks small triangles; half of them have all vertices on a coarse lattice, so that many samples
// are exactly on edges.
template <class Rasteriser>
Faults check_random_edges(const Rasteriser& rasterise, int edges, std::uint64_t seed) {
  Random random(seed);
  Faults faults;
  for (int i = 0; i < edges;) {
    // Two bits of random numbers for each coordinate on the lattice, 9 bits otherwise.
    const bool lattice = (i & 1) != 0;
    const auto vertex = [&](std::uint64_t bits) {
      return lattice
                 ? SnappedVertex{std::int32_t(bits & 3) * 256 + 128,
                                 std::int32_t((bits >> 2) & 3) * 256 + 128}
                 : SnappedVertex{std::int32_t(bits & 0x2ff), std::int32_t((bits >> 10) & 0x2ff)};
    };
    const SnappedVertex a = vertex(random.bits()), b = vertex(random.bits() >> 7);
    const SnappedVertex c = vertex(random.bits()), d = vertex(random.bits() >> 7);
    const int side = side_of(a, b, c);
    if (side == 0 || side_of(a, b, d) != -side) continue;
    ++i;
    check_edge(rasterise, {a, b, c}, {b, a, d}, {0, 0, 4, 4}, faults);
  }
  return faults;
}

// Returns x and y with x a + y b = gcd(a, b).
std::array<std::int64_t, 2> bezout(std::int64_t a, std::int64_t b) {
  if (b == 0) return {a < 0 ? -1 : 1, 0};
  const auto [x, y] = bezout(b, a % b);
  return {y, x - (a / b) * y};
}

// Checks long edges that pass a sample of a viewport `width` px wide at the smallest possible
// distance, or through it. The sample is p, the ends are p - r and p + k r + s (s.x, s.y) with r x
// s = gcd and s in {-1, 0, 1}.
template <class Rasteriser>
Faults check_long_edges(const Rasteriser& rasterise, int edges, int width, std::uint64_t seed) {
  Random random(seed);
  Faults faults;
  for (int i = 0; i < edges;) {
    const int x = int(random.integer(0, width - 1)), y = int(random.integer(0, width - 1));
    const std::int64_t px = x * 256 + 128, py = y * 256 + 128;
    const std::int64_t reach = std::int64_t(width) * 64;
    const std::int64_t rx = random.integer(-reach, reach), ry = random.integer(-reach, reach);
    if (rx == 0 && ry == 0) continue;
    const auto [t, minus_s] = bezout(rx, ry);  // rx t + ry minus_s = gcd
    const std::int64_t s = random.integer(-1, 1);
    const SnappedVertex a{std::int32_t(px - rx), std::int32_t(py - ry)};
    const SnappedVertex b{std::int32_t(px + rx - s * minus_s), std::int32_t(py + ry + s * t)};
    const auto anywhere = [&] {
      return SnappedVertex{std::int32_t(random.integer(-reach, 5 * reach)),
                           std::int32_t(random.integer(-reach, 5 * reach))};
    };
    const SnappedVertex c = anywhere(), d = anywhere();
    const int side = side_of(a, b, c);
    if (side == 0 || side_of(a, b, d) != -side) continue;
    ++i;
    check_edge(rasterise, {a, b, c}, {b, a, d}, {x, y, x + 1, y + 1}, faults);
  }
  return faults;
}

// ---- grids ----

// Draws a grid of n by n cells of about `cell` 1/256 px, whose inner vertices are moved by less
// than half a cell, and whose cells are cut by a diagonal inside them (either, by chance). Counts
// the samples inside the square that are not covered exactly once.
template <class Rasteriser>
Faults check_grid(const Rasteriser& rasterise, int n, int cell, int lattice, std::uint64_t seed) {
  Random random(seed);
  const auto jitter = [&](int i) {
    const std::int32_t free =
        i == 0 || i == n ? 0 : std::int32_t(random.integer(-cell / 5, cell / 5));
    return (i * cell + free) / lattice * lattice + 128;
  };
  std::vector<SnappedVertex> vertices;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const std::int32_t x = jitter(i);
      vertices.push_back({x, jitter(j)});
    }
  }
  const int pixels = (n * cell / lattice * lattice + 255) /
                     256;  // centres from 0.5 on are inside or on the left border
  const PixelRect window{0, 0, pixels, pixels};
  std::vector<std::uint8_t> count(std::size_t(pixels) * std::size_t(pixels));
  const auto draw = [&](int x, int y) {
    ++count[std::size_t(y) * std::size_t(pixels) + std::size_t(x)];
  };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const auto at = [&](int di, int dj) {
        return vertices[std::size_t((j + dj) * (n + 1) + i + di)];
      };
      // Windings differ on purpose.
      if (random.integer(0, 1) == 0) {
        rasterise({at(0, 0), at(1, 0), at(1, 1)}, window, draw);
        rasterise({at(0, 0), at(0, 1), at(1, 1)}, window, draw);
      } else {
        rasterise({at(0, 0), at(1, 0), at(0, 1)}, window, draw);
        rasterise({at(1, 0), at(1, 1), at(0, 1)}, window, draw);
      }
    }
  }
  Faults faults;
  for (const std::uint8_t c : count) {
    ++faults.samples;
    faults.gaps += c == 0;
    faults.doubles += c > 1;
  }
  return faults;
}

// ---- fans ----

// Draws N triangles around the centre of pixel (10, 10), to points in order along a square around
// it.
template <class Rasteriser>
Faults check_fan(const Rasteriser& rasterise, int n, Random& random) {
  constexpr int kSide = 1800;  // 1/256 px
  const auto on_square = [](int s) {
    const int edge = s / kSide, along = s % kSide - kSide / 2, half = kSide / 2;
    const int x = edge == 0 ? along : edge == 1 ? half : edge == 2 ? -along : -half;
    const int y = edge == 0 ? -half : edge == 1 ? along : edge == 2 ? half : -along;
    return SnappedVertex{10 * 256 + 128 + x, 10 * 256 + 128 + y};
  };
  // Evenly spaced, then moved by less than a quarter of their distance, so that consecutive points
  // are less than half a turn apart.
  std::vector<SnappedVertex> rim;
  for (int i = 0; i < n; ++i) {
    const double at = (i + random.between(-0.12, 0.12)) * 4 * kSide / n;
    rim.push_back(on_square((int(at) + 4 * kSide) % (4 * kSide)));
  }
  const PixelRect window{0, 0, 21, 21};
  std::array<int, 21 * 21> count{};
  const auto draw = [&](int x, int y) { ++count[std::size_t(y * 21 + x)]; };
  for (int i = 0; i < n; ++i) {
    rasterise({SnappedVertex{2688, 2688}, rim[std::size_t(i)], rim[std::size_t((i + 1) % n)]},
              window, draw);
  }
  Faults faults;
  faults.samples = 1;
  faults.gaps = count[10 * 21 + 10] == 0;
  for (const int c : count) faults.doubles += c > 1;
  return faults;
}

void require_none(const Faults& faults) {
  CAPTURE(faults.samples, faults.gaps, faults.doubles);
  REQUIRE(faults.samples > 0);
  REQUIRE(faults.gaps == 0);
  REQUIRE(faults.doubles == 0);
}

}  // namespace

TEST_CASE(
    "every sample on a shared edge belongs to exactly one triangle: 10^6 random edges (C-45)") {
  require_none(check_random_edges(Real{}, 1000000, 45));
}

TEST_CASE(
    "samples at the smallest distance from long edges belong to one triangle in 2 K to 32 K "
    "viewports (C-50)") {
  for (const int width : {1920, 7680, 32768}) {
    CAPTURE(width);
    require_none(check_long_edges(Real{}, 60000, width, std::uint64_t(width)));
  }
}

TEST_CASE("a jittered grid of 500 by 500 cells has neither gaps nor doubles (C-45)") {
  require_none(check_grid(Real{}, 500, 500, 1, 500));
}

TEST_CASE(
    "a grid whose vertices all lie on pixel centres has neither gaps nor doubles (C-43, C-45)") {
  require_none(check_grid(Real{}, 200, 1280, 256, 200));
}

TEST_CASE("fans of 3 to 256 triangles around a pixel centre cover it exactly once (C-44)") {
  Random random(44);
  for (int n = 3; n <= 256; ++n) {
    CAPTURE(n);
    require_none(check_fan(Real{}, n, random));
  }
}

TEST_CASE("the watertightness checks catch edges that all own their samples") {
  const WithoutTieRule<true> inclusive;
  Random random(44);
  CHECK(check_random_edges(inclusive, 2000, 1).doubles > 0);
  CHECK(check_long_edges(inclusive, 2000, 7680, 1).doubles > 0);
  CHECK(check_grid(inclusive, 20, 1280, 256, 1).doubles > 0);
  CHECK(check_fan(inclusive, 5, random).doubles > 0);
}

TEST_CASE("the watertightness checks catch edges none of which owns its samples") {
  const WithoutTieRule<false> exclusive;
  Random random(44);
  CHECK(check_random_edges(exclusive, 2000, 1).gaps > 0);
  CHECK(check_long_edges(exclusive, 2000, 7680, 1).gaps > 0);
  CHECK(check_grid(exclusive, 20, 1280, 256, 1).gaps > 0);
  CHECK(check_fan(exclusive, 5, random).gaps > 0);
}

TEST_CASE("the watertightness checks catch edge functions in float (C-50)") {
  for (const int width : {1920, 7680, 32768}) {
    const Faults faults = check_long_edges(FloatDifferences{}, 20000, width, 50);
    CAPTURE(width, faults.samples, faults.gaps, faults.doubles);
    CHECK(faults.gaps > 0);
    CHECK(faults.doubles > 0);
  }
}

TEST_CASE(
    "a T-junction leaves the gaps of the sliver it makes, and none once the vertex is inserted "
    "(C-46)") {
  const std::uint64_t seed = 46;
  INFO("seed " << seed);
  Random random(seed);
  const PixelRect window{0, 0, 100, 100};
  const Real rasterise;
  std::int64_t gaps_in_all = 0;
  for (int i = 0; i < 200; ++i) {
    const auto coordinate = [&](double low, double high) {
      return std::int32_t(random.between(low, high) * 256);
    };
    // The edge a-b runs from left to right. The big triangle is above it, two are below it and meet
    // at m, which is a point of the edge until snapping moves it off the edge.
    const SnappedVertex a{coordinate(0, 10), coordinate(40, 60)},
        b{coordinate(90, 100), coordinate(40, 60)};
    const SnappedVertex top{coordinate(30, 70), 0}, bottom{coordinate(30, 70), 100 * 256};
    const double t = random.between(0.3, 0.7);
    const SnappedVertex m{std::int32_t(std::lround(a.x + t * (b.x - a.x))),
                          std::int32_t(std::lround(a.y + t * (b.y - a.y)))};
    const int side = side_of(a, b, m);  // > 0: below the edge, a gap; < 0: covered twice

    std::vector<int> count(10000);
    const auto draw = [&](int x, int y) { ++count[std::size_t(y * 100 + x)]; };
    rasterise({a, bottom, m}, window, draw);
    rasterise({m, bottom, b}, window, draw);
    std::vector<int> inserted = count;
    rasterise({a, b, top}, window, draw);
    const auto draw_inserted = [&](int x, int y) { ++inserted[std::size_t(y * 100 + x)]; };
    rasterise({a, m, top}, window, draw_inserted);
    rasterise({m, b, top}, window, draw_inserted);

    std::int64_t predicted = 0, found = 0, wrong_when_inserted = 0;
    for (int y = 0; y < 100; ++y) {
      for (int x = 0; x < 100; ++x) {
        const std::size_t p = std::size_t(y * 100 + x);
        const bool sliver = side != 0 && covers_exactly({a, b, m}, x, y);
        predicted += sliver;
        if (sliver) found += count[p] == (side > 0 ? 0 : 2);
        wrong_when_inserted += inserted[p] > 1 || (sliver && inserted[p] != 1);
      }
    }
    CAPTURE(i, side);
    REQUIRE(found == predicted);
    REQUIRE(wrong_when_inserted == 0);
    if (side > 0) gaps_in_all += found;
  }
  REQUIRE(gaps_in_all > 0);
}
