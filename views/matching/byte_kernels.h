// The inner loops of the matching sweep that computes with bytes (byte_sweep.h), compiled once for
// each instruction set. They use only integers, so that every instruction set gives the same
// results.
#pragma once

#include <array>
#include <cstdint>

#include <glassbox/raster/lanes/target.h>

namespace glassbox::views {

// A census word has four bytes. Each byte is stored in a plane of its own (a plane of all first
// bytes, a plane of all second bytes ...), so that the bits of 32 words can be counted at once.
inline constexpr int kCensusBytes = 4;
inline constexpr int kByteLanes = 32;  // bytes in the largest vector that is used
template <class Byte>
using CensusPointers = std::array<Byte*, kCensusBytes>;

// The cost, and the sum of costs, of a disparity without a right pixel: every other sum is less.
inline constexpr std::uint8_t kNoMatchCost = 255;

// One row of a picture. In arrays with a number for each pixel and disparity, the numbers of a
// pixel begin at pixel * stride. Arrays of the right picture's pixels are in reversed order,
// because growing disparities lead to right pixels further and further to the left: the right
// pixels for the left pixel x begin at width - 1 - x.
struct ByteRow {
  int width, stride;  // in pixels; disparities of a pixel, padded to whole vectors
  CensusPointers<const std::uint8_t> left, right;
  // kNoMatchCost where the right pixel would be outside of the picture, else 0.
  const std::uint8_t* outside;
  // [stride]: kNoMatchCost for the padding behind the last disparity of the range, else 0.
  const std::uint8_t* past_range;
  const std::uint8_t *grey, *grey_above;
  const std::uint8_t* jumps;  // [256], penalty for a jump of disparity, by the change of grey
  std::uint8_t p1, most_bits;
  std::uint8_t* costs;
  // The values of the path from above, for each pixel; from pixel to pixel it is `cell` entries.
  // They are overwritten with the values of this row.
  std::uint8_t* above;
  std::uint8_t* least_above;  // for each pixel, the least value of `above`; overwritten
  int cell;
  // The values at one pixel of the path along the row. Indices from -1 to `stride` can be read.
  std::uint8_t* along;
  std::uint8_t* sums;
};

// The results of the search for a row's winners (the disparities with the least sums), and
// best_mask, an input.
struct ByteWinners {
  // `stride` zeros, then 3 times kNoMatchCost, then `stride` zeros. Laid over a pixel's sums, this
  // mask hides the best sum and its two neighbours when the second best is searched for.
  const std::uint8_t* best_mask;
  std::uint16_t* best;                   // [width]: number of the disparity with the least sum
  std::uint8_t *least, *second;          // [width]; `second` leaves out the best and its neighbours
  std::uint8_t* right_least;             // least sums for right pixels; kNoMatchCost: none
  std::uint8_t *right_low, *right_high;  // number of the disparity of right_least
};

// One row of costs from census words and colours, in 16 bits: census_weight * min(differing bits,
// most_bits) + color_weight * min(sum of the three channels' differences, most_color). A bit is
// compared only if the neighbour that it describes has a colour similar to its centre's in both
// pictures. The right picture's pixels are in reversed order, as in ByteRow.
struct ColorRow {
  int width, stride;
  CensusPointers<const std::uint8_t> left, left_similar, right, right_similar;
  std::array<const std::uint8_t*, 3> left_color, right_color;
  std::uint8_t census_weight, most_bits, color_weight, most_color;
  std::uint16_t* costs;
};

// The five rows of the census window. Each begins and ends with three more pixels, because the
// window reaches three pixels to either side, and has kByteLanes further bytes, because whole
// vectors are loaded.
using CensusRows = std::array<const std::uint8_t*, 5>;

struct ByteKernels {
  // Writes a bit for each neighbour: whether it is darker than the centre.
  void (*darker)(const CensusRows& grey, int width, const CensusPointers<std::uint8_t>& out);
  // Writes a bit for each neighbour: whether it is similar, that is, all its channels differ from
  // the centre's by at most `limit`. If fewer than `least` neighbours are similar, the bits of all
  // are set.
  void (*similar)(const std::array<CensusRows, 3>& channels, std::uint8_t limit, std::uint8_t least,
                  int width, const CensusPointers<std::uint8_t>& out);
  void (*color_costs)(const ColorRow& row);
  // Computes the costs, the values of the paths from the left and from above, and the sums of these
  // two values.
  void (*sweep_right)(const ByteRow& row);
  // Computes the values of the path from the right, and adds them to the sums.
  void (*sweep_left)(const ByteRow& row);
  void (*winners)(const ByteRow& row, const ByteWinners& winners);
};

const ByteKernels& byte_kernels(Target target);

}  // namespace glassbox::views
