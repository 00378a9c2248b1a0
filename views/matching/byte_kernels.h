// The inner loops of the sweep in bytes, compiled once for each instruction set. All are integer work: every target gives the same bytes.
#pragma once

#include <array>
#include <cstdint>

#include <glassbox/raster/lanes/target.h>

namespace glassbox::views {

// A census word's four bytes, each in a plane of its own, so that the bits of 32 words are counted at a time.
inline constexpr int kCensusBytes = 4;
inline constexpr int kByteLanes = 32;  // of the widest instruction set that is used
template <class Byte>
using CensusPointers = std::array<Byte*, kCensusBytes>;

inline constexpr std::uint8_t kBeside =
    255;  // the cost and the sum of what no match is: no other sum is as great

// One row of a picture. What belongs to a pixel and its disparities begins at pixel * stride, but for what belongs to the right
// picture's pixels: those are from the last one on, because the disparities grow to the left, and those of pixel x begin at
// width - 1 - x.
struct ByteRow {
  int width, stride;  // pixels; disparities of a pixel, filled up to whole lanes
  CensusPointers<const std::uint8_t> left, right;
  const std::uint8_t* beside;  // kBeside where the right pixel lies beside the picture, else 0
  const std::uint8_t* beyond;  // of one pixel: kBeside where there is no such disparity, else 0
  const std::uint8_t *grey, *grey_above;
  const std::uint8_t* jumps;  // [256], by the change of grey
  std::uint8_t p1, most_bits;
  std::uint8_t* costs;
  std::uint8_t*
      above;  // values of the path from above, `cell` from one pixel's to the next one's; overwritten
  std::uint8_t* least_above;  // of each pixel; overwritten
  int cell;
  std::uint8_t*
      along;  // of one pixel: values of the path along the row. May be read from -1 to stride
  std::uint8_t* sums;
};

// Where the winners of a row go, and what they are sought with.
struct ByteWinners {
  const std::uint8_t* apart;     // 3 kBeside behind `stride` zeros, and as many zeros behind them
  std::uint16_t* best;           // [width]: number of the least sum's disparity
  std::uint8_t *least, *second;  // [width]; the second is sought beside the best and its neighbours
  std::uint8_t* right_least;     // of the right picture's pixels, kBeside where there is none
  std::uint8_t *right_low, *right_high;  // its number's bytes
};

// One row of costs of census and colour, in 16 bits: census_weight * min(bits that differ, of neighbours that are alike their centres
// in both pictures, most) + color_weight * min(sum of the channels' differences, most). Again the right picture's pixels are from the
// last one on.
struct ColorRow {
  int width, stride;
  CensusPointers<const std::uint8_t> left, left_alike, right, right_alike;
  std::array<const std::uint8_t*, 3> left_color, right_color;
  std::uint8_t census_weight, most_bits, color_weight, most_color;
  std::uint16_t* costs;
};

// The rows of the census window, with three pixels more before and behind, and kByteLanes behind those.
using CensusRows = std::array<const std::uint8_t*, 5>;

struct ByteKernels {
  // For each neighbour whether it is darker than the centre.
  void (*darker)(const CensusRows& grey, int width, const CensusPointers<std::uint8_t>& out);
  // For each neighbour whether no channel is further off than `limit`; where fewer than `least` are so, all are said to be.
  void (*alike)(const std::array<CensusRows, 3>& channels, std::uint8_t limit, std::uint8_t least,
                int width, const CensusPointers<std::uint8_t>& out);
  void (*color_costs)(const ColorRow& row);
  // Costs, the paths from the left and from above, and their sum.
  void (*sweep_right)(const ByteRow& row);
  // The path from the right, which is added.
  void (*sweep_left)(const ByteRow& row);
  void (*winners)(const ByteRow& row, const ByteWinners& winners);
};

const ByteKernels& byte_kernels(Target target);

}  // namespace glassbox::views
