// The chunks of a PNG file (PNG, third edition, 5.3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include <glassbox/base/error.h>

namespace glassbox {

struct PngChunk {
  std::string_view type;                     // "IDAT"
  std::span<const std::byte> type_and_data;  // those of the check sum
  std::string_view data;
  std::uint32_t crc = 0;  // as the file has it
};

// Returns the bytes behind the signature of a PNG; none for another file.
std::span<const std::byte> png_chunks(std::span<const std::byte> bytes);

// Takes a chunk from the front of `rest`. An error where it runs past the end.
Result<PngChunk> take_png_chunk(std::span<const std::byte>& rest);

}  // namespace glassbox
