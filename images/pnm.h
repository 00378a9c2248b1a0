// Reads PBM, PGM, PPM, PAM and PFM files for decode.h, read.h and stored_image.h.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include <glassbox/images/decode.h>
#include <glassbox/images/stored_image.h>

namespace glassbox {

bool is_pnm(std::span<const std::byte> bytes);  // starts with P1 to P7
bool is_pfm(std::span<const std::byte> bytes);  // starts with Pf or PF

// Where a PBM, PGM, PPM or PAM picture ends in its file.
struct PnmEnd {
  std::size_t at = 0;  // bytes up to its last sample
  // Whether the binary file's header ends in CR LF and a byte is left over, as in files that were
  // written in text mode.
  bool has_line_feed_too_many = false;
};

// `end`, if given, is set.
Result<StoredImage> decode_pnm_stored(std::span<const std::byte> bytes, const DecodeLimits& limits,
                                      PnmEnd* end = nullptr);
Result<StoredImage> decode_pfm_stored(std::span<const std::byte> bytes, const DecodeLimits& limits);

// What is wrong with a file that has a line feed too many.
std::string line_feed_text();

Result<StoredHeader> stored_header_of_pnm(std::span<const std::byte> bytes,
                                          const DecodeLimits& limits);
Result<StoredHeader> stored_header_of_pfm(std::span<const std::byte> bytes,
                                          const DecodeLimits& limits);

}  // namespace glassbox
