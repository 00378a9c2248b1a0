// Limits on the resources for a scene file. Files may be hostile; a user who trusts a file can
// raise the limits.
#pragma once

#include <cstdint>

namespace glassbox {

struct LoadLimits {
  // The size of one file.
  std::uint64_t max_file_bytes = std::uint64_t(4) << 30;
  // All images of a scene together, decoded; and the longer side of each, in pixels.
  std::uint64_t max_image_pixels = std::uint64_t(1) << 26;
  std::uint32_t max_image_side = 32768;
  // The depth of the node hierarchy.
  std::uint32_t max_node_depth = 1024;
  // All meshes of a scene together, each instance counted.
  std::uint64_t max_corners = std::uint64_t(1) << 30;
};

}  // namespace glassbox
