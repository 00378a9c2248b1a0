// Compares the pixels that a rasterizer covers with the right ones, and computes the exact answer.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <glassbox/images/image.h>
#include <glassbox/pipeline/stages.h>
#include <glassbox/raster/snap.h>
#include <glassbox/raster/stages.h>

#include "exact/coverage.h"
#include "study/extremes/common/extreme_case.h"

namespace glassbox::study {

using ScreenTriangle = std::array<ScreenVertex, 3>;
using exact::SnappedTriangle;

// A rasterizer: calls the visitor for each pixel of the window that it considers covered.
using PixelVisitor = std::function<void(int x, int y)>;
using CoverageFunction =
    std::function<void(const ScreenTriangle&, const PixelRect& window, const PixelVisitor& visit)>;

// The pipeline's own rasterizer: setup_triangle and for_each_covered.
void pipeline_covers(const ScreenTriangle& triangle, const PixelRect& window,
                     const PixelVisitor& visit);

inline ScreenVertex screen_vertex(double x, double y, float depth = 0.5f, float inverse_w = 1) {
  return {{float(x), float(y), depth}, inverse_w};
}
inline ScreenTriangle screen_triangle(const SnappedTriangle& t) {
  const auto place = [](const SnappedVertex& v) { return screen_vertex(v.x / 256.0, v.y / 256.0); };
  return {place(t[0]), place(t[1]), place(t[2])};
}

// ---- the exact answer ----

// Whether the triangle covers the centre of pixel (x, y), computed with 128-bit integers.
bool covers_exactly(const SnappedTriangle& triangle, std::int64_t x, std::int64_t y);

// Counts the pixels of the window whose coverage differs from the exact one, for each triangle
// alone. A pixel that is visited twice also counts.
struct CoverageFaults {
  std::int64_t samples = 0, missing = 0, extra = 0;
  std::int64_t wrong() const { return missing + extra; }
  double share_wrong() const { return double(wrong()) / double(samples); }
  Outcome outcome() const;  // for example "3 missing, 4 extra of 1,200 samples"
};
void compare_coverage(const CoverageFunction& covers, const ScreenTriangle& triangle,
                      const PixelRect& window, CoverageFaults& faults);

// ---- meshes ----

// Counts how often each pixel of a picture is covered by the triangles.
Image<int> times_covered(const CoverageFunction& covers,
                         const std::vector<ScreenTriangle>& triangles, int width, int height);

// Checks pixels that should be covered exactly once: a pixel covered 0 times is a gap, one covered
// twice or more is a double.
struct Watertightness {
  std::int64_t samples = 0, gaps = 0, doubles = 0;
  void add(const Image<int>& times);
  Outcome outcome() const;  // for example "of 1,200 samples, 3 are not covered, ..."
};

// `columns` x `rows` quads of two triangles each, which fill the picture and extend 2 px beyond its
// edges; inner vertices are moved by up to `jitter` times the size of a quad.
std::vector<ScreenTriangle> jittered_grid(int columns, int rows, int width, int height,
                                          double jitter, std::uint64_t seed);

// ---- pictures ----

// Draws each pixel as a square of side `scale`: black if it is covered once, red if not at all,
// yellow if more than once.
std::string coverage_png(const Image<int>& times, int scale);
std::string png_of(const Image<Rgba8>& picture, int scale = 1);

}  // namespace glassbox::study
