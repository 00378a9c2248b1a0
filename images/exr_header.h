// The header of an OpenEXR file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <glassbox/images/decode.h>

namespace glassbox {

// The numbers are those in the file.
enum class ExrType : std::uint8_t { kUint = 0, kHalf = 1, kFloat = 2 };
enum class ExrCompression : std::uint8_t {
  kNone = 0,
  kRle = 1,
  kZips = 2,  // zlib, one row a chunk
  kZip = 3,   // zlib, 16 rows a chunk
  kPiz = 4,
  kPxr24 = 5,
  kB44 = 6,
  kB44a = 7,
};

struct ExrChannel {
  std::string_view name;  // in the file's bytes
  ExrType type = ExrType::kHalf;
  bool is_perceptual = false;  // the file calls it pLinear; it matters for B44's halves alone

  std::size_t bytes() const { return type == ExrType::kHalf ? 2 : 4; }
};

// The bytes of one sample of each channel.
std::size_t exr_pixel_bytes(std::span<const ExrChannel> channels);

// A rectangle of pixels with its first and its last column and row.
struct ExrWindow {
  std::int32_t left = 0, top = 0, right = 0, bottom = 0;

  std::int64_t width() const { return std::int64_t(right) - left + 1; }
  std::int64_t height() const { return std::int64_t(bottom) - top + 1; }
  friend bool operator==(const ExrWindow&, const ExrWindow&) = default;
};

struct ExrHeader {
  ExrWindow data;                    // the pixels that are stored
  ExrWindow display;                 // the picture's frame, which can be larger or smaller
  std::vector<ExrChannel> channels;  // sorted by name, as the samples are
  ExrCompression compression = ExrCompression::kNone;
  bool has_tiles = false;
  int chunk_width = 0, chunk_height = 0;  // px; at the right and the lower edge chunks are smaller
  std::size_t end = 0;                    // bytes up to the table of the chunks' offsets

  int width() const { return int(data.width()); }    // px
  int height() const { return int(data.height()); }  // px
  std::size_t pixels() const { return std::size_t(width()) * std::size_t(height()); }
};

// Reads the header of a file of one part, of scan lines or of tiles, whose channels all have the
// full resolution. Checks the size of the data window as decode_image does. The samples of all
// channels may have kWidestPixelBytes for each pixel that the limits allow. Other files are refused
// by name.
Result<ExrHeader> read_exr_header(std::span<const std::byte> bytes, const DecodeLimits& limits);

}  // namespace glassbox
