// Differences as colours: black where nothing differs, then violet, red, orange, yellow and white
// for larger differences.
#pragma once

#include <array>
#include <cstdint>

#include <glassbox/compare/pixels/differences.h>
#include <glassbox/images/image.h>

namespace glassbox {

inline constexpr std::uint8_t kHeatSame = 0;              // compared and equal
inline constexpr std::uint8_t kHeatNotCompared = 255;     // not compared
inline constexpr std::uint8_t kHeatMovedEdge = 253;       // set aside: a moved edge
inline constexpr std::uint8_t kHeatBelowThreshold = 252;  // set aside: below the threshold
// 1 to 251, and 254 for the largest: the size of the difference
inline constexpr std::uint8_t kHeatHottest = 254;

// Whether the level is that of a difference that counts.
constexpr bool is_heat(std::uint8_t level) {
  return level != kHeatSame && (level < kHeatBelowThreshold || level == kHeatHottest);
}

// The level of a map for a step of the ramp in [0, 254]; the two steps below the hottest are those
// of pixels that are set aside, and become the one below them.
constexpr std::uint8_t level_of_ramp(int step) {
  const bool taken = step == kHeatMovedEdge || step == kHeatBelowThreshold;
  return std::uint8_t(taken ? kHeatBelowThreshold - 1 : step);
}

// The colour of each level: a single step is clearly visible, pixels that are left out are
// blue-grey, moved edges are green, and what is below the threshold is blue.
const std::array<Rgba8, 256>& heat_colours();

// The colour for a fraction of the limit: as heat_colours, but with black blended into the low end,
// because here the smallest values need not be noticed.
Rgba8 heat_colour(double share);

// The level of a difference in steps, on a logarithmic scale that ends at the largest difference of
// the format (for floats at 2^24 ulps, a factor of four).
std::uint8_t heat_level(std::uint32_t steps, const StoredImage& image);

// One level per pixel.
Image<std::uint8_t> heat_map(const PicturePair& pair);

// The levels as a picture in heat_colours.
Image<Rgba8> heat_picture(const Image<std::uint8_t>& levels);

}  // namespace glassbox
