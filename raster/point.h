// Which pixel a point covers: the unit square around it holds exactly one pixel centre, squares being closed at the
// left and the top like triangles.
#pragma once

#include <glassbox/raster/stages.h>

namespace glassbox {

struct PointPixel {
  int x = 0, y = 0;
};

// The centre c with p - 1/2 <= c < p + 1/2.
inline PointPixel point_pixel(const SnappedVertex& point) {
  return {(point.x - 1) >> kSubpixelBits, (point.y - 1) >> kSubpixelBits};
}

}  // namespace glassbox
