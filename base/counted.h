// A number and what it counts.
#pragma once

#include <concepts>
#include <string>
#include <string_view>

namespace glassbox {

// Returns the word that agrees with the count: `one` for 1 ("is"), else `many` ("are"). For a noun
// whose plural ends in "s" only the singular has to be passed.
inline std::string singular_or_plural(std::integral auto count, std::string_view one,
                                      std::string_view many = {}) {
  if (count != 1 && many.empty()) return std::string(one).append("s");
  return std::string(count == 1 ? one : many);
}

// Returns the count with its noun: "1 mesh", "2 meshes".
inline std::string counted(std::integral auto count, std::string_view one,
                           std::string_view many = {}) {
  return std::to_string(count) + " " + singular_or_plural(count, one, many);
}

}  // namespace glassbox
