// Text for messages about glTF files.
#pragma once

#include <string>
#include <string_view>

#include <glassbox/base/error.h>
#include <glassbox/base/printable.h>

namespace glassbox::gltf {

// An error whose place begins with the place around it: "mesh 2, primitive 0, " and then the
// error's own place.
inline tl::unexpected<Error> fail_inside(const std::string& place, const Error& error) {
  return fail(place + ", " + error.place, error.cause, error.remedy);
}

// Returns a text such as "accessor 7".
inline std::string entry(std::string_view kind, std::size_t index) {
  return std::string(kind) + " " + std::to_string(index);
}

}  // namespace glassbox::gltf
