// Bounds that hold for every fragment of a draw, computed from the draw's box alone. All rounding
// errors are included.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <glassbox/raster/depth.h>
#include <glassbox/raster/stages.h>
#include <glassbox/render/engine/draw_list.h>

namespace glassbox {

// A range of depth codes from the nearest to the farthest, both included.
struct DepthCodes {
  std::uint32_t nearest = 0, farthest = kEmptyDepth;
};

// A coordinate of clip space over a box: its exact values at the corners, and the largest error of
// the value computed in float.
struct ClipCoordinate {
  std::array<double, 8> at_corner{};
  double error = 0;
  double largest_term = 0;  // the largest sum of absolute values in its computation
};

// The range for everything in a box with these z and w.
DepthCodes depth_codes(const ClipCoordinate& z, const ClipCoordinate& w, const View& view,
                       DepthFormat format);

DepthCodes depth_codes(const Draw& draw, const View& view, DepthFormat format);

// The range for one triangle that has been snapped.
DepthCodes depth_codes(const TriangleSetup& triangle, DepthFormat format);

// A rectangle of pixels that contains all that is seen of the draw; it may extend beyond the
// picture. Nothing if the box reaches the eye. `margin_px`: as for classify_draw_box.
std::optional<PixelRect> pixels_of_box(const Draw& draw, const View& view, double margin_px);

}  // namespace glassbox
