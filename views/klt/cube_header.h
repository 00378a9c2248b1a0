// Raw cubes of numbers with a header in text, as ENVI has them: X.hdr says how the bytes of the file beside it are to be read
// (www.nv5geospatialsoftware.com/docs/ENVIHeaderFiles.html).
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

// Numbers as ENVI counts them: its "data type".
enum class CubeType {
  kByte = 1,
  kInt16 = 2,
  kInt32 = 3,
  kFloat = 4,
  kDouble = 5,
  kUint16 = 12,
  kUint32 = 13
};

// Band after band, line after line with its bands, pixel after pixel with its bands.
enum class Interleave { kBsq, kBil, kBip };

struct CubeHeader {
  std::uint64_t width = 0, height = 0, bands = 0, offset = 0;
  CubeType type = CubeType::kByte;
  Interleave interleave = Interleave::kBsq;
  bool big_endian = false;
  std::vector<std::string> names;  // of the bands; empty, or one for each

  std::uint64_t bytes_of_sample() const;
  std::uint64_t bytes() const { return offset + width * height * bands * bytes_of_sample(); }
};

inline constexpr std::uint64_t kMostBands = 512;

// Refused: no "ENVI" at its beginning, samples, lines, bands or data type that are missing, not numbers or beyond 16384 px and kMostBands,
// complex numbers, an interleave that is none, names that are not as many as bands.
Result<CubeHeader> parse_cube_header(std::string_view text);

// Doubles, band after band, little-endian.
std::string cube_header_text(const Bands& bands);
std::vector<std::byte> cube_bytes(const Bands& bands);

// What may follow the numbers.
inline constexpr std::uint64_t kMostBeyondCube = 1 << 20;
// Refused: fewer bytes than the header says, or that much more.
Result<void> check_cube_size(const CubeHeader& header, std::uint64_t bytes);
// Refused: the same. Names that it does not have are "band 1" ...
Result<Bands> decode_cube(const CubeHeader& header, std::span<const std::byte> bytes);

}  // namespace glassbox::views
