// Makes three edge functions from three snapped vertices (Pineda 1988).
#pragma once

#include <array>
#include <optional>

#include <glassbox/pipeline/stages.h>
#include <glassbox/raster/stages.h>

namespace glassbox {

// The pixels whose centres are in the bounding box of the three points.
PixelRect pixels_in_box(const std::array<SnappedVertex, 3>& vertices);

PixelRect intersect(const PixelRect& a, const PixelRect& b);

// Returns nothing for a triangle whose area is zero after snapping: it covers no pixel.
std::optional<TriangleSetup> setup_triangle(const std::array<ScreenVertex, 3>& vertices);
// Makes the setup from vertices that are already snapped.
std::optional<TriangleSetup> setup_triangle(const std::array<ScreenVertex, 3>& vertices,
                                            const std::array<SnappedVertex, 3>& snapped);

}  // namespace glassbox
