// What every fragment of a draw keeps to, from its box alone, whatever rounds.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <glassbox/raster/depth.h>
#include <glassbox/raster/stages.h>
#include <glassbox/render/engine/draw_list.h>

namespace glassbox {

// Depth codes from the nearest to the farthest, both included.
struct DepthCodes {
  std::uint32_t nearest = 0, farthest = kEmptyDepth;
};

// A coordinate of clip space over a box: its values at the corners, and how far what is computed in float may be off.
struct ClipCoordinate {
  std::array<double, 8> at_corner{};
  double error = 0;
  double largest_term = 0;  // of the sums that it is computed by
};

// Of everything in a box with these z and w.
DepthCodes depth_codes(const ClipCoordinate& z, const ClipCoordinate& w, const View& view,
                       DepthFormat format);

DepthCodes depth_codes(const Draw& draw, const View& view, DepthFormat format);

// Of one triangle, which has been snapped.
DepthCodes depth_codes(const TriangleSetup& triangle, DepthFormat format);

// Pixels, of the picture or beside it, outside of which nothing of the draw is seen; nothing where the box reaches the eye. `margin_px`:
// as for place_box.
std::optional<PixelRect> pixels_of_box(const Draw& draw, const View& view, double margin_px);

}  // namespace glassbox
