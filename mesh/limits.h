// How much a scene file may ask for. Files are hostile until proved otherwise; a user who trusts one can raise these.
#pragma once

#include <cstdint>

namespace glassbox {

struct LoadLimits {
  // One file.
  std::uint64_t max_file_bytes = std::uint64_t(4) << 30;
  // All images of a scene together, decoded; and the longer side of each, in pixels.
  std::uint64_t max_image_pixels = std::uint64_t(1) << 26;
  std::uint32_t max_image_side = 32768;
  // Nesting of the node hierarchy.
  std::uint32_t max_node_depth = 1024;
  // All meshes of a scene together, after instancing.
  std::uint64_t max_corners = std::uint64_t(1) << 30;
};

}  // namespace glassbox
