// The headers of PBM, PGM, PPM, PAM and PFM files (netpbm.sourceforge.net/doc), for pnm.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include <glassbox/base/error.h>
#include <glassbox/images/decode.h>

namespace glassbox {

// Reads words that are separated by white space and comments (from # to the end of the line).
class NetpbmWords {
public:
  explicit NetpbmWords(std::span<const std::byte> bytes) : bytes_(bytes) {}

  // The next word, or its first 33 characters; empty at the end of the bytes.
  std::string word();
  // The next word as a number; none if it is no number, or larger than 32 bits.
  std::optional<std::uint32_t> number();
  // The next character that is neither white space nor a comment; -1 at the end.
  int digit();
  // The words of the rest of this line; then the next line begins.
  std::string rest_of_line();

  std::size_t at() const { return at_; }
  int character() const { return at_ < bytes_.size() ? int(bytes_[at_]) : -1; }
  bool at_space() const;

private:
  void skip_spaces();
  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
};

struct NetpbmHeader {
  std::string magic;         // "P6"
  std::uint32_t width = 0;   // px
  std::uint32_t height = 0;  // px
  std::uint32_t channels = 0;
  // The largest sample, 1 to 65535; for PFM it is 0, and the scale below holds.
  std::uint32_t largest = 0;
  double scale = 0;      // of PFM: below zero for little-endian floats
  std::size_t size = 0;  // bytes before the first sample
};

// Reads the header, and checks the size against the limits and the length of the file.
Result<NetpbmHeader> read_netpbm_header(std::span<const std::byte> bytes,
                                        const DecodeLimits& limits);

// Returns the bytes after the header, if there are at least `needed` of them.
Result<std::span<const std::byte>> netpbm_samples(const NetpbmHeader& header,
                                                  std::span<const std::byte> bytes,
                                                  std::uint64_t needed);

}  // namespace glassbox
