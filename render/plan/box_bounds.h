// What every fragment of a draw keeps to, from its box alone, whatever rounds.
#pragma once

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
DepthCodes depth_codes(const Draw& draw, const View& view, DepthFormat format);

// Of one triangle, which has been snapped.
DepthCodes depth_codes(const TriangleSetup& triangle, DepthFormat format);

// Pixels, of the picture or beside it, outside of which nothing of the draw is seen; nothing where the box reaches the eye. `margin_px`:
// as for place_box.
std::optional<PixelRect> pixels_of_box(const Draw& draw, const View& view, double margin_px);

}  // namespace glassbox
