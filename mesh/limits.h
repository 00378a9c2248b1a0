// Limits on the resources for a scene file. Files may be hostile; a user who trusts a file can
// raise the limits.
#pragma once

#include <cstdint>

namespace glassbox {

struct LoadLimits {
  // The size of one file.
  std::uint64_t max_file_bytes = std::uint64_t(4) << 30;
  // The sum of the pixels of all images of a scene, decoded; and the longest side of an image in
  // pixels.
  std::uint64_t max_image_pixels = std::uint64_t(1) << 26;
  std::uint32_t max_image_side = 32768;
  // The largest number of levels of the node hierarchy.
  std::uint32_t max_node_depth = 1024;
  // The sum of the corners of all meshes of a scene, counted once for each instance.
  std::uint64_t max_corners = std::uint64_t(1) << 30;
};

}  // namespace glassbox
