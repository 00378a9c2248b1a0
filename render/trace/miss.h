// By how much a triangle misses a pixel's centre.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include <glassbox/raster/stages.h>

namespace glassbox {

struct Miss {
  int x = 0, y = 0;  // the pixel
  // Of TriangleSetup::edges: the one that its centre lies furthest outside of.
  std::size_t edge = 0;
  std::int64_t value = 0;  // E there, exactly; 0 on an edge that belongs to the neighbour
  // How far outside of that edge's line the centre lies: -value / (the edge's length), in 1/256 px. Moving the edge by
  // as much brings it to the centre. Right to 2 ulps.
  double subpixels = 0;
};

// Nothing where the triangle covers the centre of pixel (x, y).
std::optional<Miss> miss_at(const TriangleSetup& triangle, int x, int y);

// The smallest of the misses in `pixels`, which is not empty and of which the triangle covers none. Time in proportion
// to the rows.
Miss nearest_miss(const TriangleSetup& triangle, const PixelRect& pixels);

}  // namespace glassbox
