// Undoes PIZ, OpenEXR's compression by wavelets.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <glassbox/images/exr_unpack.h>

namespace glassbox {

// As unpack_exr, for chunks that are packed with PIZ.
std::optional<std::vector<std::byte>> undo_piz(std::span<const std::byte> packed,
                                               const ExrChunk& chunk);

}  // namespace glassbox
