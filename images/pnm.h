// Reads PPM, PGM and PFM files for read.h and stored_image.h.
#pragma once

#include <cstddef>
#include <span>

#include <glassbox/images/decode.h>
#include <glassbox/images/stored_image.h>

namespace glassbox {

bool is_pnm(std::span<const std::byte> bytes);  // starts with P5 or P6
bool is_pfm(std::span<const std::byte> bytes);  // starts with Pf or PF

Result<StoredImage> decode_pnm_stored(std::span<const std::byte> bytes, const DecodeLimits& limits);
Result<StoredImage> decode_pfm_stored(std::span<const std::byte> bytes, const DecodeLimits& limits);

Result<StoredHeader> stored_header_of_pnm(std::span<const std::byte> bytes,
                                          const DecodeLimits& limits);
Result<StoredHeader> stored_header_of_pfm(std::span<const std::byte> bytes,
                                          const DecodeLimits& limits);

}  // namespace glassbox
