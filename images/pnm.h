// What the PPM and PFM readers share: a header of words and numbers, then raw samples.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include <glassbox/images/decode.h>

namespace glassbox {

struct NetpbmHeader {
  std::string magic;        // "P6"
  std::uint64_t width = 0;  // px
  std::uint64_t height = 0;
  std::string last;      // the largest sample of PPM and PGM, the scale of PFM
  std::size_t size = 0;  // bytes before the first sample
};

// Reads the header and checks the size against the limits.
Result<NetpbmHeader> read_netpbm_header(std::span<const std::byte> bytes,
                                        const DecodeLimits& limits);

}  // namespace glassbox
