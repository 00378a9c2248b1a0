// Reads JPEG, BMP and TGA files for decode.h and stored_image.h.
#pragma once

#include <cstddef>
#include <span>

#include <glassbox/images/decode.h>
#include <glassbox/images/stored_image.h>

namespace glassbox {

// Whether the bytes start like a JPEG, BMP or TGA file. TGA has no signature, so any plausible
// header is accepted.
bool is_stb_format(std::span<const std::byte> bytes);

// Decodes a file for which is_stb_format is true.
Result<Image<Rgba8>> decode_with_stb(std::span<const std::byte> bytes, const DecodeLimits& limits);
Result<StoredImage> decode_stored_with_stb(std::span<const std::byte> bytes,
                                           const DecodeLimits& limits);
Result<StoredHeader> stored_header_with_stb(std::span<const std::byte> bytes,
                                            const DecodeLimits& limits);

// Returns nothing where stb could not read the file.
std::optional<ImageSize> find_size_with_stb(std::span<const std::byte> bytes);

}  // namespace glassbox
