// Lines with wrong pixels at their ends.
#pragma once

#include <cmath>
#include <cstdlib>

#include <glassbox/raster/line.h>

#include "study/extremes/common/coverage.h"

namespace glassbox::study::naive {

// Draws from the rounded first pixel to the rounded last one, including both: two lines that meet
// in a pixel both draw it.
inline void bresenham(const SnappedVertex& a, const SnappedVertex& b, const PixelVisitor& visit) {
  int x = a.x >> 8, y = a.y >> 8;
  const int x1 = b.x >> 8, y1 = b.y >> 8;
  const int dx = std::abs(x1 - x), dy = -std::abs(y1 - y);
  const int step_x = x < x1 ? 1 : -1, step_y = y < y1 ? 1 : -1;
  int error = dx + dy;
  for (;;) {
    visit(x, y);
    if (x == x1 && y == y1) return;
    const int twice = 2 * error;
    if (twice >= dy) {
      error += dy;
      x += step_x;
    }
    if (twice <= dx) {
      error += dx;
      y += step_y;
    }
  }
}

// The right rule (a pixel is drawn if the line leaves its diamond), plus the pixel in whose diamond
// the line ends.
inline void line_with_last_pixel(const SnappedVertex& a, const SnappedVertex& b,
                                 const PixelVisitor& visit) {
  for_each_line_pixel(a, b, {-64, -64, 64, 64}, [&](const LinePixel& p) { visit(p.x, p.y); });
  const int x = b.x >> kSubpixelBits, y = b.y >> kSubpixelBits;
  if (in_diamond(b, x, y)) visit(x, y);
}

// The right rule, but without the pixel in whose diamond the line starts, if the line starts past
// the centre of that diamond.
inline void line_without_start(const SnappedVertex& a, const SnappedVertex& b,
                               const PixelVisitor& visit) {
  const LineSetup line = setup_line(a, b);
  for (int major = line.first; major < line.end; ++major) {
    const int minor = line.minor_at(major);
    const int x = line.x_major ? major : minor, y = line.x_major ? minor : major;
    if (!in_diamond(b, x, y)) visit(x, y);
  }
}

}  // namespace glassbox::study::naive
