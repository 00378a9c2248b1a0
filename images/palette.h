// Pictures whose pixels are the indices of colours.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include <glassbox/images/image.h>

namespace glassbox {

// The colours for which the indices stand. The palette has a colour for each of them.
inline Image<Rgba8> coloured(const Image<std::uint8_t>& indices, std::span<const Rgba8> palette) {
  Image<Rgba8> picture(indices.width, indices.height);
  std::transform(indices.pixels.begin(), indices.pixels.end(), picture.pixels.begin(),
                 [&](std::uint8_t index) { return palette[index]; });
  return picture;
}

}  // namespace glassbox
