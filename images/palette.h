// Pictures whose pixels are the indices of colours.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

namespace glassbox {

// An error if the palette has no colour for an index of the picture, or more than 256 colours.
inline Result<void> check_palette(const Image<std::uint8_t>& indices,
                                  std::span<const Rgba8> palette) {
  const auto last = std::max_element(indices.pixels.begin(), indices.pixels.end());
  if (palette.size() > 256) {
    return fail("", "the palette has " + std::to_string(palette.size()) + " colours",
                "use 256 colours at most");
  }
  if (last != indices.pixels.end() && *last >= palette.size()) {
    return fail("", "the palette has no colour " + std::to_string(*last),
                "give a colour for every index");
  }
  return {};
}

// The colours for which the indices stand. The palette must have a colour for each of them.
inline Image<Rgba8> coloured(const Image<std::uint8_t>& indices, std::span<const Rgba8> palette) {
  Image<Rgba8> picture(indices.width, indices.height);
  std::transform(indices.pixels.begin(), indices.pixels.end(), picture.pixels.begin(),
                 [&](std::uint8_t index) { return palette[index]; });
  return picture;
}

}  // namespace glassbox
