#include "study/extremes/common/coverage.h"

#include <cmath>

#include <fmt/format.h>

#include <glassbox/base/random.h>
#include <glassbox/images/write.h>
#include <glassbox/raster/coverage.h>

namespace glassbox::study {

void pipeline_covers(const ScreenTriangle& triangle, const PixelRect& window,
                     const PixelVisitor& visit) {
  const auto setup = setup_triangle(triangle);
  if (!setup) return;
  for_each_covered(*setup, window, [&](const Coverage& pixel) { visit(pixel.x, pixel.y); });
}

bool covers_exactly(const SnappedTriangle& t, std::int64_t x, std::int64_t y) {
  __extension__ typedef __int128 Int128;
  return exact::covers<Int128>(t, x, y);
}

Outcome CoverageFaults::outcome() const {
  return must_be_zero(double(wrong()), fmt::format("of {2} samples, {0} are not covered but should "
                                                   "be, and {1} are covered but should not be",
                                                   missing, extra, samples));
}

void compare_coverage(const CoverageFunction& covers, const ScreenTriangle& triangle,
                      const PixelRect& window, CoverageFaults& faults) {
  if (window.empty()) return;
  Image<int> times(window.x1 - window.x0, window.y1 - window.y0);
  covers(triangle, window, [&](int x, int y) { ++times.at(x - window.x0, y - window.y0); });
  const SnappedTriangle snapped = exact::snapped(triangle);
  for (int y = window.y0; y < window.y1; ++y) {
    for (int x = window.x0; x < window.x1; ++x) {
      const int right = covers_exactly(snapped, x, y) ? 1 : 0;
      const int found = times.at(x - window.x0, y - window.y0);
      ++faults.samples;
      faults.missing += found < right;
      faults.extra += found > right;
    }
  }
}

Image<int> times_covered(const CoverageFunction& covers,
                         const std::vector<ScreenTriangle>& triangles, int width, int height) {
  Image<int> times(width, height);
  for (const ScreenTriangle& triangle : triangles) {
    covers(triangle, {0, 0, width, height}, [&](int x, int y) { ++times.at(x, y); });
  }
  return times;
}

void Watertightness::add(const Image<int>& times) {
  for (const int count : times.pixels) {
    ++samples;
    gaps += count == 0;
    doubles += count > 1;
  }
}

Outcome Watertightness::outcome() const {
  return must_be_zero(
      double(gaps + doubles),
      fmt::format("of {2} samples, {0} are not covered, and {1} are covered more than once", gaps,
                  doubles, samples));
}

std::vector<ScreenTriangle> jittered_grid(int columns, int rows, int width, int height,
                                          double jitter, std::uint64_t seed) {
  Random random(seed);
  const double cell_x = (width + 4.0) / columns, cell_y = (height + 4.0) / rows;
  std::vector<ScreenVertex> vertices;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      const bool inner = i > 0 && i < columns && j > 0 && j < rows;
      const double dx = inner ? random.between(-jitter, jitter) * cell_x : 0;
      const double dy = inner ? random.between(-jitter, jitter) * cell_y : 0;
      vertices.push_back(screen_vertex(-2 + i * cell_x + dx, -2 + j * cell_y + dy));
    }
  }
  std::vector<ScreenTriangle> triangles;
  const auto at = [&](int i, int j) { return vertices[std::size_t(j * (columns + 1) + i)]; };
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return triangles;
}

std::string png_of(const Image<Rgba8>& picture, int scale) {
  Image<Rgba8> large(picture.width * scale, picture.height * scale);
  for (int y = 0; y < large.height; ++y) {
    for (int x = 0; x < large.width; ++x) large.at(x, y) = picture.at(x / scale, y / scale);
  }
  const auto bytes = encode_png(large);
  if (!bytes) return {};
  return {reinterpret_cast<const char*>(bytes->data()), bytes->size()};
}

std::string coverage_png(const Image<int>& times, int scale) {
  Image<Rgba8> picture(times.width, times.height);
  for (std::size_t i = 0; i < times.pixels.size(); ++i) {
    const int count = times.pixels[i];
    // Vermilion and yellow from the palette of Okabe and Ito, which people with any kind of colour
    // vision can tell apart.
    picture.pixels[i] = count == 0   ? Rgba8{213, 94, 0, 255}
                        : count == 1 ? Rgba8{40, 44, 52, 255}
                                     : Rgba8{240, 228, 66, 255};
  }
  return png_of(picture, scale);
}

}  // namespace glassbox::study
