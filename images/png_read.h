// Reads PNG files for decode.h and stored_image.h.
#pragma once

#include <cstddef>
#include <span>

#include <glassbox/images/decode.h>
#include <glassbox/images/stored_image.h>

namespace glassbox {

bool is_png(std::span<const std::byte> bytes);
Result<Image<Rgba8>> decode_png(std::span<const std::byte> bytes, const DecodeLimits& limits);
Result<StoredImage> decode_png_stored(std::span<const std::byte> bytes, const DecodeLimits& limits);
// As decode_png_stored, in a longer time: it makes no use of decode_plain_png.
Result<StoredImage> decode_with_libpng(std::span<const std::byte> bytes,
                                       const DecodeLimits& limits);
Result<StoredHeader> stored_header_of_png(std::span<const std::byte> bytes,
                                          const DecodeLimits& limits);

}  // namespace glassbox
