// Words of the messages about glTF files.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <glassbox/base/printable.h>

namespace glassbox::gltf {

// "accessor 7"
inline std::string entry(std::string_view kind, std::size_t index) {
  return std::string(kind) + " " + std::to_string(index);
}

// "1 mesh", "2 meshes"
inline std::string counted(std::uint64_t n, const std::string& one, const std::string& many = "") {
  return std::to_string(n) + " " + (n == 1 ? one : many.empty() ? one + "s" : many);
}

}  // namespace glassbox::gltf
