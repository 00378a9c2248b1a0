// Raw cubes of numbers with a text header in ENVI's format: X.hdr says how the bytes of the file
// beside it are to be read (www.nv5geospatialsoftware.com/docs/ENVIHeaderFiles.html).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glassbox/base/error.h>

#include "views/klt/bands.h"

namespace glassbox::views {

// The types of numbers, with the values of ENVI's field "data type".
enum class CubeType {
  kByte = 1,
  kInt16 = 2,
  kInt32 = 3,
  kFloat = 4,
  kDouble = 5,
  kUint16 = 12,
  kUint32 = 13
};

// The order of the numbers: band by band (kBsq), line by line with all bands of a line (kBil), or
// pixel by pixel with all bands of a pixel (kBip).
enum class Interleave { kBsq, kBil, kBip };

struct CubeHeader {
  std::uint64_t width = 0, height = 0, bands = 0, offset = 0;
  CubeType type = CubeType::kByte;
  Interleave interleave = Interleave::kBsq;
  bool big_endian = false;
  std::vector<std::string> names;  // of the bands; empty, or one for each band

  std::uint64_t bytes_of_sample() const;
  std::uint64_t bytes() const { return offset + width * height * bands * bytes_of_sample(); }
};

inline constexpr std::uint64_t kMaxBands = 512;

// Refused: no "ENVI" at the beginning of the text; samples, lines, bands or data type that are
// missing, not numbers or beyond 16384 px and kMaxBands; complex numbers; an unknown interleave; a
// number of names other than the number of bands.
Result<CubeHeader> parse_cube_header(std::string_view text);

// The header and the numbers of a cube of these bands: doubles, band by band, little-endian.
std::string cube_header_text(const Bands& bands);
std::vector<std::byte> cube_bytes(const Bands& bands);

// How many bytes may follow the numbers in the file.
inline constexpr std::uint64_t kMaxTrailingBytes = 1 << 20;
// Refused: fewer bytes than the header demands, or more than kMaxTrailingBytes bytes too many.
Result<void> check_cube_size(const CubeHeader& header, std::uint64_t bytes);
// Decodes the numbers, and refuses what check_cube_size refuses. Bands without a name are named
// "band 1", "band 2" ...
Result<Bands> decode_cube(const CubeHeader& header, std::span<const std::byte> bytes);

}  // namespace glassbox::views
