// Words of the messages about glTF files.
#pragma once

#include <string>
#include <string_view>

#include <glassbox/base/printable.h>

namespace glassbox::gltf {

// "accessor 7"
inline std::string entry(std::string_view kind, std::size_t index) {
  return std::string(kind) + " " + std::to_string(index);
}

}  // namespace glassbox::gltf
