// The orientation that cameras write into a JPEG: how to turn its pixels so that the picture stands
// upright (Exif 2.32, 4.6.4 A).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <glassbox/images/decode.h>

namespace glassbox {

// The orientation in the Exif segment of a JPEG, 1 to 8; 1, as stored, for files without one or
// with a broken one.
int exif_orientation(std::span<const std::byte> jpeg);

// Whether width and height change places.
inline bool is_sideways(int orientation) {
  return orientation >= 5;
}
inline ImageSize upright_size(int orientation, ImageSize stored) {
  return is_sideways(orientation) ? ImageSize{stored.height, stored.width} : stored;
}

// Writes the pixels of a picture as it stands upright. `stored` and `upright` have as many pixels,
// of `channels` bytes each.
void turn_upright(int orientation, ImageSize size, std::size_t channels, const std::uint8_t* stored,
                  std::uint8_t* upright);

}  // namespace glassbox
