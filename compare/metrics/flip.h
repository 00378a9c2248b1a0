// LDR-FLIP: how different two pictures look when they are shown in turns.
//
// Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild: FLIP: A Difference Evaluator for Alternating
// Images. Proceedings of the ACM on Computer Graphics and Interactive Techniques 3(2), 2020.
#pragma once

#include <cstdint>

#include <glassbox/compare/metrics/flip_tile.h>
#include <glassbox/compare/pixels/differences.h>
#include <glassbox/images/image.h>

namespace glassbox {

// Of the errors of the compared pixels, each in [0, 1]: 0 nothing to see, 1 as far apart as can be.
struct FlipErrors {
  std::uint64_t pixels = 0;
  double mean = 0;  // off by 2^-33 at most: fixed_sum.h
  // The smallest error, to the nearest 2^-16, that half of the pixels do not exceed.
  double median = 0;
  double p95 = 0;  // the same for 95 in 100 pixels
  double max = 0;
};

// Colours are sRGB, grey stands for r = g = b; 16-bit samples are used as they are. Where a pixel of either picture is
// not opaque, both are laid over black and over white and the larger error counts. Seen at 67 pixels per degree. The
// pair must not have floats.
//
// Memory: 2 MB a thread beyond the pictures. `tiles` (at most kLargestFlipTile) and the number of threads have no
// influence on the result.
FlipErrors flip(const PicturePair& pair, TileSize tiles = kLargestFlipTile);

// The errors as levels of heat_map.h: 0 for none, 1 to 254 in proportion, rounded up, kHeatLeftOut where not compared.
Image<std::uint8_t> flip_heat_map(const PicturePair& pair);

}  // namespace glassbox
