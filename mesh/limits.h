// How much a scene file may ask for. Files are hostile until proved otherwise; a user who trusts one can raise these.
#pragma once

#include <cstdint>

namespace glassbox {

struct LoadLimits {
  std::uint64_t max_file_bytes = std::uint64_t(4) << 30;  // one file
  std::uint64_t max_image_pixels = std::uint64_t(1) << 26;  // all images of a scene together, decoded
  std::uint32_t max_image_side = 32768;                   // px
  std::uint32_t max_node_depth = 1024;                    // nesting of the node hierarchy
  std::uint64_t max_corners = std::uint64_t(1) << 30;     // all meshes of a scene together, after instancing
};

}  // namespace glassbox
