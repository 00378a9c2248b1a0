// The GLB format: a header and chunks, the first of JSON, the second of binary data.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glassbox/base/error.h>

namespace glassbox::gltf {

// Views of the file's bytes.
struct Container {
  std::string_view json;
  std::optional<std::span<const std::byte>> binary;  // the data of buffer 0 if that has no URI
  std::vector<std::string> warnings;
};

// Splits a GLB file into its parts; a file without GLB's magic number is JSON as a whole.
Result<Container> open_container(std::span<const std::byte> bytes);

}  // namespace glassbox::gltf
