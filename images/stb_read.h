// The JPEG, BMP and TGA part of decode.h and stored_image.h.
#pragma once

#include <cstddef>
#include <span>

#include <glassbox/images/decode.h>
#include <glassbox/images/stored_image.h>

namespace glassbox {

// Whether the bytes start like a JPEG, BMP or TGA file. TGA has no signature, only a plausible header.
bool is_stb_format(std::span<const std::byte> bytes);

// The picture of a file that is_stb_format.
Result<Image<Rgba8>> decode_with_stb(std::span<const std::byte> bytes, const DecodeLimits& limits);
Result<StoredImage> decode_stored_with_stb(std::span<const std::byte> bytes,
                                           const DecodeLimits& limits);
Result<StoredHeader> stored_header_with_stb(std::span<const std::byte> bytes,
                                            const DecodeLimits& limits);

// Nothing where stb could not read the file.
std::optional<ImageSize> find_size_with_stb(std::span<const std::byte> bytes);

}  // namespace glassbox
