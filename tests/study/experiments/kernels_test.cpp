// The kernels timed in D-2 to D-5 are those whose errors are measured there.
#include <tests/support/catch.h>

#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "study/experiments/kernels/edge_kernels.h"
#include "study/experiments/kernels/reciprocal_kernels.h"
#include "study/experiments/reciprocal_table.h"

#include <glassbox/base/random.h>

namespace glassbox::study {
namespace {

// Clockwise triangles (y down) whose corners are up to `reach` px from the tile's middle, on
// multiples of `step` / 256 px.
std::vector<TileEdges> random_edges(std::int64_t reach, std::int64_t step, int count) {
  Random random(11);
  std::vector<TileEdges> triangles;
  while (int(triangles.size()) < count) {
    std::array<std::int64_t, 3> x, y;
    for (std::size_t k = 0; k < 3; ++k) {
      x[k] = step * random.integer(-reach * 256 / step, reach * 256 / step) + kEdgeTile * 128;
      y[k] = step * random.integer(-reach * 256 / step, reach * 256 / step) + kEdgeTile * 128;
    }
    const std::int64_t area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    if (area <= 0) continue;
    TileEdges t;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      t.x0[k] = std::int32_t(x[k]), t.y0[k] = std::int32_t(y[k]);
      t.dx[k] = std::int32_t(x[next] - x[k]), t.dy[k] = std::int32_t(y[next] - y[k]);
      const bool owns_zero = t.dy[k] < 0 || (t.dy[k] == 0 && t.dx[k] > 0);
      t.bias[k] = owns_zero ? 0 : 1;
    }
    triangles.push_back(t);
  }
  return triangles;
}

std::int64_t count_exactly(const std::vector<TileEdges>& triangles) {
  std::int64_t covered = 0;
  for (const TileEdges& t : triangles) {
    for (std::int64_t py = 128; py < kEdgeTile * 256; py += 256) {
      for (std::int64_t px = 128; px < kEdgeTile * 256; px += 256) {
        bool inside = true;
        for (std::size_t k = 0; k < 3; ++k)
          inside = inside && t.dx[k] * (py - t.y0[k]) - t.dy[k] * (px - t.x0[k]) - t.bias[k] >= 0;
        covered += inside;
      }
    }
  }
  return covered;
}

}  // namespace

TEST_CASE("the integer edge kernels count what exact arithmetic counts, near and far (D-3)") {
  // Corners on half pixels, so that edges pass through pixel centres.
  for (const std::int64_t step : {1, 128}) {
    for (const std::int64_t reach : {40, 1000, 16000}) {
      CAPTURE(step, reach);
      const auto triangles = random_edges(reach, step, 200);
      const std::int64_t right = count_exactly(triangles);
      REQUIRE(right > 0);
      CHECK(count_covered(EdgeArithmetic::kInt32Tile, triangles) == right);
      CHECK(count_covered(EdgeArithmetic::kInt64, triangles) == right);
    }
  }
}

// Edges up to 64 px long have products below 2^24 * 2^6: the float forms are wrong only where a
// centre is on an edge, because none of them applies a tie rule. About one centre in 2^8 next to an
// edge is on it.
TEST_CASE("the floating-point edge kernels count the same but for ties (D-3)") {
  const auto triangles = random_edges(40, 1, 200);
  const std::int64_t right = count_exactly(triangles);
  for (const EdgeArithmetic arithmetic :
       {EdgeArithmetic::kFloatDifference, EdgeArithmetic::kFloatPlane, EdgeArithmetic::kFloatFma,
        EdgeArithmetic::kDouble}) {
    const std::int64_t counted = count_covered(arithmetic, triangles);
    CHECK(std::abs(counted - right) <= 200 * 3 * 2 * kEdgeTile / 256);
  }
}

// x86 promises 1.5 * 2^-12; NEON has 8 bits and one table 2^-11. The bound for all is 2^-7.
TEST_CASE("the instructions approximate, and Newton's step squares what they miss (D-5)") {
  Random random(12);
  std::vector<float> w(1024), out(w.size());
  for (float& x : w) x = float(random.between(1e-3, 1e3));
  const auto largest = [&](Reciprocal method, bool root) {
    reciprocals(method, w, out);
    double error = 0;
    for (std::size_t i = 0; i < w.size(); ++i) {
      const double x = root ? std::sqrt(double(w[i])) : double(w[i]);
      error = std::max(error, std::abs(double(out[i]) * x - 1));
    }
    return error;
  };
  CHECK(largest(Reciprocal::kDivide, false) <= 0x1p-24);
  CHECK(largest(Reciprocal::kRootDivide, true) <= 0x1p-23);
  const double rough = largest(Reciprocal::kApproximate, false);
  CHECK(rough < 0x1p-7);
  CHECK(largest(Reciprocal::kNewton, false) <= rough * rough + 3 * 0x1p-24);
  const double rough_root = largest(Reciprocal::kRootApproximate, true);
  CHECK(rough_root < 0x1p-7);
  CHECK(largest(Reciprocal::kRootNewton, true) <= 1.5 * rough_root * rough_root + 4 * 0x1p-24);
}

// The magic constant is used in integer arithmetic and Newton's step consists of three rounded
// products, so lanes give the same bits as scalar code.
TEST_CASE("0x5f3759df gives the same bits in lanes (D-5)") {
  Random random(13);
  std::vector<float> w(1024), out(w.size());
  for (float& x : w) x = float(random.between(1e-3, 1e3));
  reciprocals(Reciprocal::kMagicNewton, w, out);
  for (std::size_t i = 0; i < w.size(); ++i)
    CHECK(out[i] == newton_reciprocal_root(w[i], magic_reciprocal_root(w[i])));
}

TEST_CASE("lines look up the texel that exact perspective names, where the divide is exact (D-4)") {
  std::vector<std::int32_t> texture(kLinePixels), out(kLinePixels);
  std::iota(texture.begin(), texture.end(), 0);
  const PerspectiveLine line{0, 256, 1, 0.125f};
  for (const Perspective method : {Perspective::kDivide, Perspective::kNewton}) {
    draw_lines(method, {&line, 1}, texture, out);
    for (int x = 0; x < kLinePixels; ++x) {
      const double far = (x + 0.5) / kLinePixels;
      const double u = 256 * 0.125 * far / ((1 - far) + 0.125 * far);
      // Six roundings of 256 texels, 2^-13, matter only at a texel's border.
      if (std::abs(u - std::floor(u + 0.5)) < 0x1p-12) continue;
      CHECK(out[std::size_t(x)] == std::int32_t(std::floor(u)));
    }
  }
  draw_lines(Perspective::kAffine, {&line, 1}, texture, out);
  for (int x = 0; x < kLinePixels; ++x) CHECK(out[std::size_t(x)] == x);
}

TEST_CASE("lines of any length end where they should, in spans and pixel by pixel (D-4)") {
  std::vector<std::int32_t> texture(kLinePixels), out(2 * kLinePixels);
  std::iota(texture.begin(), texture.end(), 0);
  // One texel per pixel: each pixel looks up its own number by every method.
  for (const int pixels : {1, 7, 8, 9, 31, 33, 200, 256}) {
    const PerspectiveLine line{0, float(pixels), 0.5f, 0.5f, pixels};
    const std::vector<PerspectiveLine> two{line, line};
    for (const Perspective method :
         {Perspective::kDivide, Perspective::kEvery8, Perspective::kEvery16, Perspective::kEvery32,
          Perspective::kAffine}) {
      draw_lines(method, two, texture, out);
      for (int x = 0; x < pixels; ++x) {
        CHECK(out[std::size_t(x)] == x);
        CHECK(out[std::size_t(kLinePixels + x)] == x);
      }
    }
  }
}

}  // namespace glassbox::study
