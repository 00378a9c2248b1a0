// Decompresses the chunks of OpenEXR files.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <glassbox/images/exr_header.h>

namespace glassbox {

// A chunk is a row, some rows, or a tile.
struct ExrChunk {
  std::size_t width = 0, height = 0;  // px
  std::span<const ExrChannel> channels;

  std::size_t bytes() const;  // of all samples
};

// Returns the samples of a chunk: row by row those of the first channel, then those of the second,
// and so on, each least significant byte first. Returns none if the packed bytes are not valid.
std::optional<std::vector<std::byte>> unpack_exr(std::span<const std::byte> packed,
                                                 ExrCompression compression, const ExrChunk& chunk);

}  // namespace glassbox
