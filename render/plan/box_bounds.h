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

// A coordinate of clip space over a box: its values at the corners, computed in double, and the
// largest error of the value that is computed in float.
struct ClipCoordinate {
  std::array<double, 8> at_corner{};
  double error = 0;
  double largest_term = 0;  // the largest sum of the absolute values of its terms
};

// Returns the range of depth codes of everything in a box that has these z and w, or in the box of
// a draw.
DepthCodes depth_codes(const ClipCoordinate& z, const ClipCoordinate& w, const View& view,
                       DepthFormat format);

DepthCodes depth_codes(const Draw& draw, const View& view, DepthFormat format);

// Returns the range of depth codes of one triangle that has been snapped.
DepthCodes depth_codes(const TriangleSetup& triangle, DepthFormat format);

// Returns a rectangle of pixels that contains all that is seen of the draw; it may extend beyond
// the picture. Returns nothing if the draw's box reaches the eye. The rectangle is enlarged by
// `margin_px` on each side.
std::optional<PixelRect> pixels_of_box(const Draw& draw, const View& view, double margin_px);

}  // namespace glassbox
