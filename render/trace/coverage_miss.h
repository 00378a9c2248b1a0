// Finds which pixels a triangle reaches on the screen, and by how much it misses a pixel's centre
// or the picture.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <glassbox/pipeline/stages.h>
#include <glassbox/raster/stages.h>
#include <glassbox/render/trace/records.h>

namespace glassbox {

bool contains(const PixelRect& pixels, int x, int y);

// Returns the pixels that the bounding box of these points reaches into, even if it does not cover
// their centres. The points must be within the guard band.
PixelRect pixels_touched(std::span<const ScreenVertex> vertices);

// Whether a triangle would reach into the pixels if nothing clipped it, the part of it in front of
// the eye. True also if it passes them by less than a pixel.
bool would_reach(const std::array<ClipVertex, 3>& corners, const Viewport& window,
                 const PixelRect& pixels);

struct CentreMiss {
  int x = 0, y = 0;  // the pixel
  // Index into TriangleSetup::edges: the edge that the pixel's centre is furthest outside of.
  std::size_t edge = 0;
  // The edge function at the centre, exact; 0 on an edge whose points belong to the neighbouring
  // triangle.
  std::int64_t value = 0;
  // How far outside that edge's line the centre is: -value / (the edge's length), in 1/256 px.
  // Moving the edge by this distance brings it to the centre. Accurate to 2 ulps.
  double subpixels = 0;
};

// Returns nothing if the triangle covers the centre of pixel (x, y).
std::optional<CentreMiss> miss_at(const TriangleSetup& triangle, int x, int y);

// Returns the smallest miss among `pixels`, which must not be empty; the triangle must cover none
// of their centres. The time is proportional to the number of rows.
CentreMiss nearest_miss(const TriangleSetup& triangle, const PixelRect& pixels);

// By how much a triangle is outside the picture on each side, in 1/256 px, exact; 0 on the sides
// where it is not outside.
struct OutsideDistances {
  std::int64_t left = 0, top = 0, right = 0, bottom = 0;
  // Set if the triangle is outside near a corner of the picture: its box reaches into the picture,
  // but the whole picture is on the outer side of one of its edges. The value is the distance of
  // that edge's line from the picture's nearest corner, in 1/256 px.
  std::optional<double> beyond_edge;
};

// Returns nothing if the snapped triangle and the rectangle of pixels have some area in common.
// `piece` must have a setup.
std::optional<OutsideDistances> outside_distances(const TracedPiece& piece,
                                                  const PixelRect& picture);

}  // namespace glassbox
