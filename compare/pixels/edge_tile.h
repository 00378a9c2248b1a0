// The values of both pictures in a tile and around it, as moved_edge.cpp needs them.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include <glassbox/compare/pixels/differences.h>

namespace glassbox {

// The size of a tile, in px. Its values fit into a processor's second cache. Larger tiles would
// have less margin for each pixel, but would do more work around lonely differences.
inline constexpr int kTileWidth = 64, kTileHeight = 32;
inline constexpr int kTileMargin = 4;  // px on each side of the tile

// Element x of a row, and row y of a plane, belong to the column and the row of the picture that
// lie x - kTileMargin and y - kTileMargin after the tile's first ones. The loops over columns have
// a fixed length, which compilers turn into instructions for several columns.
template <class Value>
using TileRow = std::array<Value, std::size_t(kTileWidth + 2 * kTileMargin)>;
template <class Value>
using TilePlane = std::array<TileRow<Value>, std::size_t(kTileHeight + 2 * kTileMargin)>;

// Values of whole-number formats are floats, which hold opaque samples of 8 and 16 bits exactly; a
// colour times its alpha is rounded, by at most 2^-24 of itself. Sums over 7 x 7 pixels have at
// most 16 roundings after one another, so each is off by less than 1e-6 of the sum of its terms'
// sizes. The smallest eigenvalue of the matrix that gives the movement is at least 1/100 of the
// trace that it had before the identity was added (see shift_around). Where values changed by no
// more than the slope of a pixel, the movement is therefore off by less than 2e-4 px, which matters
// only for a value that lies this near to its bound. Pictures of floats need doubles, because the
// squares of their values overflow a float.
template <class Sample>
using TileValue = std::conditional_t<std::is_integral_v<Sample>, float, double>;

template <class Value>
struct EdgeTile {
  int channels = 0;
  bool opaque = true;                               // whether every alpha that was loaded is 1
  std::array<TilePlane<Value>, 4> reference, test;  // by channel
  TilePlane<std::uint8_t> finite;  // 1 where the values of all channels are, in both pictures
};

// Loads row y of the tile's planes, for the tile whose first pixel is `first`. Colours are
// multiplied by their alpha. Where the selection leaves pixels out, the test has the reference's
// values. Beyond the picture's border the nearest pixels are repeated.
template <class Sample>
void load_row(const PicturePair& pair, PixelPosition first, int y,
              EdgeTile<TileValue<Sample>>& tile);

extern template void load_row<std::uint8_t>(const PicturePair&, PixelPosition, int,
                                            EdgeTile<float>&);
extern template void load_row<std::uint16_t>(const PicturePair&, PixelPosition, int,
                                             EdgeTile<float>&);
extern template void load_row<float>(const PicturePair&, PixelPosition, int, EdgeTile<double>&);

}  // namespace glassbox
