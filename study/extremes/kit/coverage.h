// Which pixels triangles cover: rasterizers under judgement, and the exact answer.
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
#include "study/extremes/kit/extreme_case.h"

namespace glassbox::study {

using ScreenTriangle = std::array<ScreenVertex, 3>;
using exact::SnappedTriangle;

// A rasterizer: calls the visitor for each pixel of the window that it thinks covered.
using Visit = std::function<void(int x, int y)>;
using Covers =
    std::function<void(const ScreenTriangle&, const PixelRect& window, const Visit& visit)>;

// The pipeline's own: setup_triangle and for_each_covered.
void pipeline_covers(const ScreenTriangle& triangle, const PixelRect& window, const Visit& visit);

inline ScreenVertex screen_vertex(double x, double y, float depth = 0.5f, float inverse_w = 1) {
  return {{float(x), float(y), depth}, inverse_w};
}
inline ScreenTriangle screen_triangle(const SnappedTriangle& t) {
  const auto place = [](const SnappedVertex& v) { return screen_vertex(v.x / 256.0, v.y / 256.0); };
  return {place(t[0]), place(t[1]), place(t[2])};
}

// ---- the exact answer ----

// In 128 bits.
bool covers_exactly(const SnappedTriangle& triangle, std::int64_t x, std::int64_t y);

// Pixels of the window whose coverage by each triangle alone is not the exact one, a pixel that is visited twice
// included.
struct CoverageFaults {
  std::int64_t samples = 0, missing = 0, extra = 0;
  std::int64_t wrong() const { return missing + extra; }
  double share_wrong() const { return double(wrong()) / double(samples); }
  Outcome outcome() const;  // "3 missing, 4 extra of 1,200 samples"
};
void compare_coverage(const Covers& covers, const ScreenTriangle& triangle, const PixelRect& window,
                      CoverageFaults& faults);

// ---- meshes ----

// How often each pixel of a picture is covered by some triangle.
Image<int> times_covered(const Covers& covers, const std::vector<ScreenTriangle>& triangles,
                         int width, int height);

// Of pixels that ought to be covered once: 0 times is a gap, twice or more a double.
struct Watertightness {
  std::int64_t samples = 0, gaps = 0, doubles = 0;
  void add(const Image<int>& times);
  Outcome outcome() const;  // "3 gaps, 4 doubles of 1,200 samples"
};

// `columns` x `rows` quads of two triangles each that fill the picture and reach 2 px over its edges; inner vertices are
// moved by up to `jitter` of a cell.
std::vector<ScreenTriangle> jittered_grid(int columns, int rows, int width, int height,
                                          double jitter, std::uint64_t seed);

// ---- pictures ----

// Black: covered once; red: not at all; yellow: more than once. Each pixel enlarged to a square of `scale`.
std::string coverage_png(const Image<int>& times, int scale);
std::string png_of(const Image<Rgba8>& picture, int scale = 1);

}  // namespace glassbox::study
