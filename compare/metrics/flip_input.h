// Converts the samples of a picture to the input of FLIP.
#pragma once

#include <glassbox/compare/metrics/flip_tile.h>

namespace glassbox {

enum class PairSide { kReference, kTest };

// Loads the opponent colours of a tile and its halo; outside the picture the nearest edge pixels
// are repeated. Pixels that the selection leaves out come from the reference for both sides. Where
// a pixel is not opaque, the background shows through in linear light; it is a grey of `background`
// (0 black, 1 white). Returns whether all pixels were opaque. The pair has no floats.
bool load_opponent(const PicturePair& pair, PairSide side, const PixelBox& tile, float background,
                   OpponentPlanes& planes);

}  // namespace glassbox
