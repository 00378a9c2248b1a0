// Reads most PNG files faster than libpng: libdeflate decompresses them in one go, instead of zlib
// a row at a time.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include <glassbox/images/decode.h>
#include <glassbox/images/stored_image.h>

namespace glassbox {

// Decodes a PNG that is plain: 8 or 16 bits a channel, neither interlaced nor with a palette or
// tRNS, within the limits, and without any fault; zlib's header must state a window that is as long
// as the data or as deflate's longest distance. Returns nothing for all other files: what is wrong
// with them, if anything, is for decode_png_stored to say. The image is the same as
// decode_png_stored's.
std::optional<StoredImage> decode_plain_png(std::span<const std::byte> bytes,
                                            const DecodeLimits& limits);

}  // namespace glassbox
