// Colours as linear light, in which anaglyphs are mixed and measured.
#pragma once

#include <array>

#include <glassbox/images/image.h>
#include <glassbox/images/srgb.h>

namespace glassbox {

// Red, green and blue. A screen can show values in [0, 1].
using Linear = std::array<float, 3>;

inline Linear linear_of(const Rgba8& pixel) {
  return {decode_srgb(pixel.r), decode_srgb(pixel.g), decode_srgb(pixel.b)};
}

// The luma weights of ITU-R BT.601, for which the published anaglyph methods were made.
inline constexpr Linear kLuma{0.299f, 0.587f, 0.114f};

inline float luma(const Linear& colour) {
  return kLuma[0] * colour[0] + kLuma[1] * colour[1] + kLuma[2] * colour[2];
}

}  // namespace glassbox
