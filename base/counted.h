// A number and what it counts.
#pragma once

#include <concepts>
#include <string>
#include <string_view>

namespace glassbox {

// The word as it goes with the number: "is" or "are". Of nouns with a plural in "s", the singular is enough.
inline std::string inflected(std::integral auto count, std::string_view one,
                             std::string_view many = {}) {
  if (count != 1 && many.empty()) return std::string(one).append("s");
  return std::string(count == 1 ? one : many);
}

// "1 mesh", "2 meshes"
inline std::string counted(std::integral auto count, std::string_view one,
                           std::string_view many = {}) {
  return std::to_string(count) + " " + inflected(count, one, many);
}

}  // namespace glassbox
