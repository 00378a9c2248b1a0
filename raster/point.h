// Finds the pixel that a point covers: the unit square around the point contains exactly one pixel
// centre. The square includes its left and top sides but not its right and bottom ones, like a
// triangle.
#pragma once

#include <glassbox/raster/stages.h>

namespace glassbox {

struct PointPixel {
  int x = 0, y = 0;
};

// Returns the pixel whose centre c satisfies p - 1/2 <= c < p + 1/2.
inline PointPixel point_pixel(const SnappedVertex& point) {
  return {(point.x - 1) >> kSubpixelBits, (point.y - 1) >> kSubpixelBits};
}

}  // namespace glassbox
