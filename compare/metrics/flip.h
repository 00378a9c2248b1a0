// LDR-FLIP: how different two pictures look when they are shown alternately.
//
// Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild: FLIP: A Difference Evaluator
// for Alternating Images. Proceedings of the ACM on Computer Graphics and Interactive Techniques
// 3(2), 2020.
#pragma once

#include <cstdint>

#include <glassbox/compare/metrics/flip_tile.h>
#include <glassbox/compare/pixels/differences.h>
#include <glassbox/images/image.h>

namespace glassbox {

// Statistics of the errors of the compared pixels, each in [0, 1]: 0 is no visible difference, 1
// the largest possible one.
struct FlipErrors {
  std::uint64_t pixels = 0;
  double mean = 0;  // error at most 2^-33: fixed_sum.h
  // The smallest error, rounded to 2^-16, that half of the pixels do not exceed.
  double median = 0;
  double p95 = 0;  // the same for 95 % of the pixels
  double max = 0;
};

// Computes the errors. Colours are sRGB, grey means r = g = b; 16-bit samples are used with full
// precision. Where a pixel of either picture is not opaque, both pictures are placed over black and
// over white, and the larger of the two errors is taken. The viewing distance is 67 pixels per
// degree. The pair must not have floats.
//
// Memory: 2 MB per thread in addition to the pictures. `tiles` (at most kLargestFlipTile) and the
// number of threads do not change the result.
FlipErrors flip(const PicturePair& pair, TileSize tiles = kLargestFlipTile);

// The errors as levels of heat_map.h, one level per pixel: 0 for no error, 1 to 254 in proportion
// to the error and rounded up, kHeatNotCompared for pixels that are not compared.
Image<std::uint8_t> flip_heat_map(const PicturePair& pair);

}  // namespace glassbox
