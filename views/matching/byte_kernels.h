// The inner loops of the sweep in bytes, compiled once for each instruction set. They use only
// integers, so that every target gives the same bytes.
#pragma once

#include <array>
#include <cstdint>

#include <glassbox/raster/lanes/target.h>

namespace glassbox::views {

// The four bytes of a census word are in four planes, so that the bits of 32 words can be counted
// at once.
inline constexpr int kCensusBytes = 4;
inline constexpr int kByteLanes = 32;  // of the widest instruction set that is used
template <class Byte>
using CensusPointers = std::array<Byte*, kCensusBytes>;

// Cost and sum of a disparity without a match: every other sum is less.
inline constexpr std::uint8_t kNoMatchCost = 255;

// One row of a picture. The numbers of a pixel and its disparities begin at pixel * stride. Arrays
// of the right picture's pixels are reversed: those of pixel x begin at width - 1 - x, because
// growing disparities go to the left.
struct ByteRow {
  int width, stride;  // pixels; disparities of a pixel, padded to whole vectors
  CensusPointers<const std::uint8_t> left, right;
  // kNoMatchCost where the right pixel would be outside of the picture, else 0.
  const std::uint8_t* outside;
  const std::uint8_t*
      past_range;  // for one pixel: kNoMatchCost where there is no such disparity, else 0
  const std::uint8_t *grey, *grey_above;
  const std::uint8_t* jumps;  // [256], penalties by the change of grey
  std::uint8_t p1, most_bits;
  std::uint8_t* costs;
  // Values of the path from above; `cell` is the step from one pixel to the next; overwritten.
  std::uint8_t* above;
  std::uint8_t* least_above;  // for each pixel; overwritten
  int cell;
  std::uint8_t*
      along;  // for one pixel: values of the path along the row. May be read from -1 to stride
  std::uint8_t* sums;
};

// The results of the search for a row's winners, and one of its inputs.
struct ByteWinners {
  // `stride` zeros, then 3 times kNoMatchCost, then `stride` zeros: a mask for the best and its
  // neighbours.
  const std::uint8_t* best_mask;
  std::uint16_t* best;           // [width]: number of the disparity with the least sum
  std::uint8_t *least, *second;  // [width]; the second does not count the best and its neighbours
  std::uint8_t* right_least;     // for the right picture's pixels; kNoMatchCost where there is none
  std::uint8_t *right_low, *right_high;  // the two bytes of its disparity's number
};

// One row of costs of census and colour, in 16 bits: census_weight * min(differing bits, most) +
// color_weight * min(sum of the channels' differences, most). Only the bits of neighbours count
// whose colour is similar to the centre's in both pictures. The right picture's pixels are in
// reversed order, too.
struct ColorRow {
  int width, stride;
  CensusPointers<const std::uint8_t> left, left_similar, right, right_similar;
  std::array<const std::uint8_t*, 3> left_color, right_color;
  std::uint8_t census_weight, most_bits, color_weight, most_color;
  std::uint16_t* costs;
};

// The rows of the census window, with three more pixels at both ends, and kByteLanes after those.
using CensusRows = std::array<const std::uint8_t*, 5>;

struct ByteKernels {
  // For each neighbour, whether it is darker than the centre.
  void (*darker)(const CensusRows& grey, int width, const CensusPointers<std::uint8_t>& out);
  // For each neighbour, whether all channels differ from the centre's by at most `limit`. If fewer
  // than `least` neighbours do, all of them count as such.
  void (*similar)(const std::array<CensusRows, 3>& channels, std::uint8_t limit, std::uint8_t least,
                  int width, const CensusPointers<std::uint8_t>& out);
  void (*color_costs)(const ColorRow& row);
  // Computes the costs, the paths from the left and from above, and the sum of both.
  void (*sweep_right)(const ByteRow& row);
  // Computes the path from the right, and adds it.
  void (*sweep_left)(const ByteRow& row);
  void (*winners)(const ByteRow& row, const ByteWinners& winners);
};

const ByteKernels& byte_kernels(Target target);

}  // namespace glassbox::views
