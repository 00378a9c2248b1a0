// Which pixels a triangle reaches on the screen, and by how much it misses the centre of one, or the picture.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <glassbox/pipeline/stages.h>
#include <glassbox/raster/stages.h>
#include <glassbox/render/trace/records.h>

namespace glassbox {

bool contains(const PixelRect& pixels, int x, int y);

// The pixels that the box of these points reaches into, whether or not it covers their centres. They lie within the guard
// band.
PixelRect pixels_touched(std::span<const ScreenVertex> vertices);

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

// By how much a piece lies beside the picture, in 1/256 px, exactly; 0 on the sides where it does not.
struct Outside {
  std::int64_t left = 0, top = 0, right = 0, bottom = 0;
  // It lies beside a corner of the picture: its box reaches into the picture, but one of its edges has the whole picture
  // on its outer side. How far that edge's line is from the picture's nearest corner, in 1/256 px.
  std::optional<double> beyond_edge;
};

// Nothing where the piece, as snapped, and the rectangle of pixels have some area in common. For pieces with a setup.
std::optional<Outside> outside_of(const TracedPiece& piece, const PixelRect& picture);

}  // namespace glassbox
