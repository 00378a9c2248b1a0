// Reads JPEG, BMP, TGA and Radiance HDR files for decode.h and stored_image.h.
#pragma once

#include <cstddef>
#include <span>

#include <glassbox/images/decode.h>
#include <glassbox/images/stored_image.h>

namespace glassbox {

enum class StbFormat : std::uint8_t { kJpeg, kBmp, kTga, kHdr };

// Whether the bytes start like a TGA file. TGA has no signature, so any plausible header of a file
// that picture_format_of does not know is accepted.
bool is_tga(std::span<const std::byte> bytes);

// HDR pictures are floats, which decode_with_stb does not read.
Result<Image<Rgba8>> decode_with_stb(StbFormat format, std::span<const std::byte> bytes,
                                     const DecodeLimits& limits, Orientation orientation);
Result<StoredImage> decode_stored_with_stb(StbFormat format, std::span<const std::byte> bytes,
                                           const DecodeLimits& limits);
Result<StoredHeader> stored_header_with_stb(StbFormat format, std::span<const std::byte> bytes,
                                            const DecodeLimits& limits);

}  // namespace glassbox
