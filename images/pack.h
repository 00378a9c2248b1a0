// Packs pixels without their alpha where every alpha is 255.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include <glassbox/images/image.h>

namespace glassbox {

inline bool is_opaque(const Image<Rgba8>& image) {
  return std::all_of(image.pixels.begin(), image.pixels.end(),
                     [](const Rgba8& pixel) { return pixel.a == 255; });
}

// Writes three (RGB) or four (RGBA) bytes per pixel, one after the other.
inline void pack_channels(std::span<const Rgba8> pixels, int channels, std::uint8_t* out) {
  for (const Rgba8& pixel : pixels) {
    *out++ = pixel.r;
    *out++ = pixel.g;
    *out++ = pixel.b;
    if (channels == 4) *out++ = pixel.a;
  }
}

}  // namespace glassbox
