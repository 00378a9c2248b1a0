// What stb_image does not check before it reads: each refuses files that it would read wrongly, or that would make it
// touch memory that is not its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <glassbox/base/error.h>

namespace glassbox {

// Walks the segments as stb does. Every Huffman table must fit its place, and the last marker must be there: stb fills
// what is missing with grey.
Result<void> check_jpeg(std::span<const std::byte> bytes);

// Rows without compression (stb reads no other), padded to 4 bytes. No pixel may choose a colour behind the end of the
// palette, which stb takes from memory that nobody has written.
Result<void> check_bmp(std::span<const std::byte> bytes, std::uint64_t width, std::uint64_t height);

// A header of 18 bytes, an identifier, a palette, and all pixels: stb fills what is missing with zeros.
Result<void> check_tga(std::span<const std::byte> bytes, std::uint64_t width, std::uint64_t height);

}  // namespace glassbox
