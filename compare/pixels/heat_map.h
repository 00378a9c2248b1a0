// Differences as colours: black where nothing differs, then violet, red, orange, yellow and white
// for larger differences.
#pragma once

#include <array>
#include <cstdint>

#include <glassbox/compare/pixels/differences.h>
#include <glassbox/images/image.h>

namespace glassbox {

inline constexpr std::uint8_t kHeatSame = 0;           // compared and equal
inline constexpr std::uint8_t kHeatNotCompared = 255;  // not compared
// 1 to 254: the size of the difference; 254 is the largest
inline constexpr std::uint8_t kHeatHottest = 254;

// The colour of each level: a single step is clearly visible, pixels that are left out are
// blue-grey.
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
