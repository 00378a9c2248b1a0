// The pictures as planes of colours and grey, from which the costs are computed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include <glassbox/base/cache_aligned_vector.h>
#include <glassbox/images/image.h>

namespace glassbox::views {

// The planes of an 8-bit picture, as stored: the costs compare sRGB codes, not linear light. Alpha
// is left out.
struct ColorPlanes {
  int width = 0, height = 0;  // in px
  CacheAlignedVector<std::uint8_t> r, g, b;
  CacheAlignedVector<std::uint8_t> grey;  // (77 r + 150 g + 29 b + 128) / 256
};
ColorPlanes color_planes(const Image<Rgba8>& image);

// The difference of two pixels in the channel that differs most, in sRGB codes (0 .. 255).
inline int channel_difference(const ColorPlanes& picture, std::size_t a, std::size_t b) {
  return std::max({std::abs(int(picture.r[a]) - int(picture.r[b])),
                   std::abs(int(picture.g[a]) - int(picture.g[b])),
                   std::abs(int(picture.b[a]) - int(picture.b[b]))});
}

}  // namespace glassbox::views
