// The samples of a picture as FLIP starts from them.
#pragma once

#include <glassbox/compare/metrics/flip_tile.h>

namespace glassbox {

enum class PairSide { kReference, kTest };

// Opponent colours of a tile and its halo; beyond the picture's edge the pixels at the edge go on. Pixels that the
// selection leaves out come from the reference for both sides. Alpha lets the background through in linear
// light, a grey of `background` (0 black, 1 white). Returns whether all pixels were opaque. The pair has no floats.
bool load_opponent(const PicturePair& pair, PairSide side, const PixelBox& tile, float background,
                   OpponentPlanes& planes);

}  // namespace glassbox
