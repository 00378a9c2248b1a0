// By how much a triangle lies beside the picture.
#pragma once

#include <glassbox/raster/stages.h>
#include <glassbox/render/trace/records.h>

namespace glassbox {

// In 1/256 px, exactly; 0 on the sides where it does not lie outside.
struct Outside {
  std::int64_t left = 0, top = 0, right = 0, bottom = 0;
  // It lies beside a corner of the picture: its box reaches into the picture, but one of its edges has the whole picture
  // on its outer side. How far that edge's line is from the picture's nearest corner, in 1/256 px.
  std::optional<double> beyond_edge;
};

// Nothing where the piece, as snapped, and the rectangle of pixels have some area in common. For pieces with a setup.
std::optional<Outside> outside_of(const TracedPiece& piece, const PixelRect& picture);

}  // namespace glassbox
