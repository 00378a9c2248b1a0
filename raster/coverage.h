// Finds the pixels that a triangle covers: the pixels whose centres are inside, or on an edge that
// the triangle owns by the top-left rule. Two triangles that share an edge traverse it in opposite
// directions, so exactly one of them owns it: no gaps, and no pixel twice.
#pragma once

#include <glassbox/raster/stages.h>
#include <glassbox/raster/triangle_setup.h>

namespace glassbox {

// Calls visit(Coverage) for every covered pixel within `window`, row by row from the top, left to
// right.
template <class Visit>
void for_each_covered(const TriangleSetup& triangle, const PixelRect& window, Visit&& visit) {
  const PixelRect box = intersect(triangle.bounds, window);
  const auto& [e0, e1, e2] = triangle.edges;
  for (int y = box.y0; y < box.y1; ++y) {
    const std::int64_t centre_x = std::int64_t(box.x0) * kSubpixels + kPixelCentre;
    const std::int64_t centre_y = std::int64_t(y) * kSubpixels + kPixelCentre;
    Coverage pixel{
        box.x0,
        y,
        {e0.at(centre_x, centre_y), e1.at(centre_x, centre_y), e2.at(centre_x, centre_y)}};
    for (; pixel.x < box.x1; ++pixel.x) {
      if (e0.covers(pixel.edges[0]) && e1.covers(pixel.edges[1]) && e2.covers(pixel.edges[2])) {
        visit(pixel);
      }
      // Step one pixel to the right. The values are integers, so any number of steps stays exact.
      pixel.edges[0] += e0.a * kSubpixels;
      pixel.edges[1] += e1.a * kSubpixels;
      pixel.edges[2] += e2.a * kSubpixels;
    }
  }
}

}  // namespace glassbox
