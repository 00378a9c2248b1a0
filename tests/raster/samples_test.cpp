// The samples of a pixel: their positions, which of them a triangle covers, and where the triangle
// is shaded.
#include <bit>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/raster/interpolate.h>
#include <glassbox/raster/samples.h>

#include "tests/raster/exact.h"
#include "tests/support/catch.h"

namespace {

using namespace glassbox;
using namespace glassbox::test;

constexpr std::array kCounts{1, 2, 4, 8, 16};

// For each pixel the bits of its covered samples, and 2^16 if the centre is covered.
using Covered = std::map<std::array<int, 2>, std::uint32_t>;
constexpr std::uint32_t kCentre = 1u << 16;

Covered covered(const SnappedTriangle& triangle, int count, const PixelRect& window) {
  Covered found;
  const auto setup = setup_triangle(screen_triangle(triangle));
  if (!setup) return found;
  const SampleSteps steps(*setup, sample_offsets(count));
  for_each_sampled(*setup, steps, window, [&](const SampledPixel& pixel) {
    found[{pixel.centre.x, pixel.centre.y}] = pixel.samples | (pixel.covers_centre ? kCentre : 0);
  });
  return found;
}

// The triangle moved so that the point at this offset from each pixel centre moves to the centre.
SnappedTriangle seen_from(const SnappedTriangle& triangle, const SampleOffset& offset) {
  SnappedTriangle moved = triangle;
  for (SnappedVertex& v : moved) v = {v.x - offset.x, v.y - offset.y};
  return moved;
}

Covered exactly_covered(const SnappedTriangle& triangle, int count, const PixelRect& window) {
  Covered found;
  const auto offsets = sample_offsets(count);
  for (int y = window.y0; y < window.y1; ++y) {
    for (int x = window.x0; x < window.x1; ++x) {
      std::uint32_t bits = covers_exactly(triangle, x, y) ? kCentre : 0;
      for (std::size_t s = 0; s < offsets.size(); ++s) {
        if (covers_exactly(seen_from(triangle, offsets[s]), x, y)) bits |= 1u << s;
      }
      if (bits != 0) found[{x, y}] = bits;
    }
  }
  return found;
}

// A triangle in and around the window; one in three is on the grid of sample positions, so that
// ties occur often.
SnappedTriangle random_triangle(Random& random, const PixelRect& w, int kind) {
  SnappedTriangle t;
  for (SnappedVertex& v : t) {
    v = {std::int32_t(random.integer((w.x0 - 2) * 256, (w.x1 + 2) * 256)),
         std::int32_t(random.integer((w.y0 - 2) * 256, (w.y1 + 2) * 256))};
    if (kind % 3 == 0) v = {v.x & ~15, v.y & ~15};
  }
  if (kind % 3 == 1) {  // smaller than a pixel
    for (std::size_t k : {1u, 2u}) {
      t[k] = {t[0].x + std::int32_t(random.integer(-150, 150)),
              t[0].y + std::int32_t(random.integer(-150, 150))};
    }
  }
  return t;
}

}  // namespace

TEST_CASE("samples lie where the Vulkan specification, too, has the standard locations") {
  using Places = std::vector<std::array<double, 2>>;  // from the pixel's upper left corner
  const std::map<int, Places> standard{
      {1, {{0.5, 0.5}}},
      {2, {{0.75, 0.75}, {0.25, 0.25}}},
      {4, {{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}}},
      {8,
       {{0.5625, 0.3125},
        {0.4375, 0.6875},
        {0.8125, 0.5625},
        {0.3125, 0.1875},
        {0.1875, 0.8125},
        {0.0625, 0.4375},
        {0.6875, 0.9375},
        {0.9375, 0.0625}}},
      {16,
       {{0.5625, 0.5625},
        {0.4375, 0.3125},
        {0.3125, 0.625},
        {0.75, 0.4375},
        {0.1875, 0.375},
        {0.625, 0.8125},
        {0.8125, 0.6875},
        {0.6875, 0.1875},
        {0.375, 0.875},
        {0.5, 0.0625},
        {0.25, 0.125},
        {0.125, 0.75},
        {0.0, 0.5},
        {0.9375, 0.25},
        {0.875, 0.9375},
        {0.0625, 0.0}}}};
  for (const auto& [count, places] : standard) {
    const auto offsets = sample_offsets(count);
    REQUIRE(offsets.size() == places.size());
    std::set<std::int32_t> columns, rows;
    for (std::size_t s = 0; s < places.size(); ++s) {
      CHECK((offsets[s].x + kPixelCentre) / 256.0 == places[s][0]);
      CHECK((offsets[s].y + kPixelCentre) / 256.0 == places[s][1]);
      columns.insert(offsets[s].x);
      rows.insert(offsets[s].y);
    }
    // No two samples share a column or a row, so an upright edge passes them one by one.
    CHECK(columns.size() == places.size());
    CHECK(rows.size() == places.size());
  }
}

TEST_CASE("a triangle covers exactly the samples that the top-left rule gives it") {
  const std::uint64_t seed = 31;
  INFO("seed " << seed);
  Random random(seed);
  const std::array<PixelRect, 3> windows{PixelRect{0, 0, 6, 5}, PixelRect{-3, -4, 3, 2},
                                         PixelRect{32763, -32768, 32768, -32763}};
  for (int i = 0; i < 9000; ++i) {
    const PixelRect& window = windows[std::size_t(random.integer(0, 2))];
    const SnappedTriangle t = random_triangle(random, window, i);
    const int count = kCounts[std::size_t(random.integer(0, 4))];
    const Covered found = covered(t, count, window), expected = exactly_covered(t, count, window);
    if (found == expected) continue;
    CAPTURE(t, count, window.x0, window.y0);
    REQUIRE(found == expected);
  }
}

TEST_CASE("every sample around a vertex belongs to exactly one triangle of its fan (C-51)") {
  Random random(51);
  const PixelRect window{0, 0, 8, 8};
  for (int i = 0; i < 600; ++i) {
    // Eight corners around the window; the middle is anywhere in it, often on a sample.
    SnappedVertex middle{std::int32_t(random.integer(0, 2048)),
                         std::int32_t(random.integer(0, 2048))};
    if (i % 2 == 0) middle = {middle.x & ~15, middle.y & ~15};
    const std::array<SnappedVertex, 8> ring{{{-512, -512},
                                             {1024, -512},
                                             {2560, -512},
                                             {2560, 1024},
                                             {2560, 2560},
                                             {1024, 2560},
                                             {-512, 2560},
                                             {-512, 1024}}};
    const int count = kCounts[std::size_t(random.integer(0, 4))];
    const std::uint32_t all = ((1u << count) - 1) | kCentre;
    Covered once;
    for (std::size_t k = 0; k < 8; ++k) {
      for (const auto& [pixel, bits] :
           covered({middle, ring[k], ring[(k + 1) % 8]}, count, window)) {
        CHECK((once[pixel] & bits) == 0);
        once[pixel] |= bits;
      }
    }
    CAPTURE(middle.x, middle.y, count);
    REQUIRE(once.size() == 64);
    for (const auto& [pixel, bits] : once) REQUIRE(bits == all);
  }
}

TEST_CASE("one sample to a pixel is its centre") {
  Random random(1);
  const PixelRect window{0, 0, 9, 9};
  for (int i = 0; i < 500; ++i) {
    for (const auto& [pixel, bits] : covered(random_triangle(random, window, i), 1, window)) {
      REQUIRE(bits == (kCentre | 1u));
    }
  }
}

TEST_CASE("a pixel is shaded at its centre if that is covered, else at its first covered sample") {
  Random random(9);
  const PixelRect window{-4, -4, 8, 8};
  int beside_the_centre = 0;
  for (int i = 0; i < 3000; ++i) {
    const SnappedTriangle t = random_triangle(random, window, i);
    const auto setup = setup_triangle(screen_triangle(t));
    if (!setup) continue;
    const int count = kCounts[std::size_t(random.integer(0, 4))];
    const auto offsets = sample_offsets(count);
    const SampleSteps steps(*setup, offsets);
    for_each_sampled(*setup, steps, window, [&](const SampledPixel& pixel) {
      const Coverage place = shading_point(pixel, steps);
      SampleOffset expected;
      if (!pixel.covers_centre) {
        std::size_t first = 0;
        while (!(pixel.samples >> first & 1u)) ++first;
        expected = offsets[first];
        ++beside_the_centre;
      }
      std::int64_t sum = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t there = setup->edges[k].at(pixel.centre.x * 256 + 128 + expected.x,
                                                      pixel.centre.y * 256 + 128 + expected.y);
        REQUIRE(place.edges[k] == there);
        REQUIRE(there >= 0);  // inside the triangle: nothing is extrapolated
        sum += there;
      }
      REQUIRE(sum == setup->double_area);
      for (const float weight : interpolate(*setup, place).lambda) {
        REQUIRE(weight >= 0);
        REQUIRE(weight <= 1.000001f);
      }
    });
  }
  CHECK(beside_the_centre > 1000);
}

TEST_CASE("the share of covered samples comes closer to the area the more samples there are") {
  // An edge leaves the error of S stratified samples in each pixel that it crosses: S^-3/4 of a
  // pixel (D-31), up to a factor that depends on the pattern and the direction. Random triangles
  // show the mean over directions.
  std::map<int, double> rms;
  for (const int count : kCounts) {
    Random random(77);
    double squares = 0;
    constexpr int kTriangles = 3000;
    for (int i = 0; i < kTriangles; ++i) {
      const PixelRect window{0, 0, 20, 20};
      SnappedTriangle t;
      for (SnappedVertex& v : t) {
        v = {std::int32_t(random.integer(0, 5120)), std::int32_t(random.integer(0, 5120))};
      }
      const auto setup = setup_triangle(screen_triangle(t));
      if (!setup) continue;
      int samples = 0;
      for (const auto& [pixel, bits] : covered(t, count, window)) {
        samples += std::popcount(bits & ~kCentre);
      }
      const double error =
          double(samples) / count - double(setup->double_area) / (2.0 * 65536);  // px^2
      squares += error * error;
    }
    rms[count] = std::sqrt(squares / kTriangles);
  }
  CAPTURE(rms[1], rms[2], rms[4], rms[8], rms[16]);
  for (const int count : {2, 4, 8, 16}) {
    const double predicted = rms[1] * std::pow(count, -0.75);
    CHECK(rms[count] > predicted / 2);
    CHECK(rms[count] < predicted * 2);
  }
}
