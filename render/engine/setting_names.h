// The names of settings, as they appear on the command line, in JSON and in reports.
#pragma once

#include <cstddef>
#include <string_view>

#include <glassbox/render/engine/settings.h>

namespace glassbox {

constexpr std::string_view name_of(Shading shading) {
  constexpr std::string_view kNames[] = {"unlit", "flat", "gouraud", "phong"};
  return kNames[std::size_t(shading)];
}

constexpr std::string_view name_of(Show show) {
  constexpr std::string_view kNames[] = {"color", "depth", "normal", "uv", "id", "overdraw"};
  return kNames[std::size_t(show)];
}

constexpr std::string_view name_of(Cull cull) {
  constexpr std::string_view kNames[] = {"material", "back", "front", "none"};
  return kNames[std::size_t(cull)];
}

constexpr std::string_view name_of(DepthFormat format) {
  constexpr std::string_view kNames[] = {"d32", "d32r", "d24", "d16"};
  return kNames[std::size_t(format)];
}

constexpr std::string_view name_of(Transfer transfer) {
  return transfer == Transfer::kSrgb ? "srgb" : "none";
}

}  // namespace glassbox
