// Checks that stb_image does not make itself, to be called before it reads a file. Each check
// refuses files that stb_image would read wrongly, or that would make it access memory that is not
// its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <glassbox/base/error.h>

namespace glassbox {

// Checks the segments of a JPEG, which it reads in the same way as stb. Every Huffman table must
// fit into its array, and the last marker must be present, because stb fills missing data with
// grey.
Result<void> check_jpeg(std::span<const std::byte> bytes);

// Refuses a BMP whose pixels are compressed, by the name of the compression: stb reads no such
// file.
Result<void> check_bmp_compression(std::span<const std::byte> bytes);

// Checks a BMP: its rows must be uncompressed (stb reads no other), padded to 4 bytes, and
// complete. No pixel may choose a colour beyond the end of the palette, which stb would read from
// uninitialised memory.
Result<void> check_bmp(std::span<const std::byte> bytes, std::uint64_t width, std::uint64_t height);

// Checks a TGA: it must have a header of 18 bytes, an identifier, a palette, and all pixels,
// because stb fills missing pixels with zeros.
Result<void> check_tga(std::span<const std::byte> bytes, std::uint64_t width, std::uint64_t height);

// Checks a Radiance HDR picture: all pixels must be there, because stb fills missing ones with
// zeros. They must be uncompressed, or every row must have the run lengths of its four bytes one
// after the other. stb misreads a mixture, and the older run lengths, where a pixel (1, 1, 1)
// repeats the one before it.
Result<void> check_hdr(std::span<const std::byte> bytes, std::uint64_t width, std::uint64_t height);

}  // namespace glassbox
