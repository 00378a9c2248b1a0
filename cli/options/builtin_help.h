// The list of built-in scenes for help texts.
#pragma once

#include <string>

#include <fmt/format.h>

#include <glassbox/mesh/builtin/scenes.h>

namespace glassbox {

inline std::string builtin_help() {
  std::string text = "Built-in scenes:\n";
  for (const BuiltinScene& scene : builtin_scenes()) {
    text += fmt::format("  {:<14}{}", scene.name, scene.description);
    if (scene.levels) {
      text += fmt::format(" ({}:{} .. {}:{})", scene.name, scene.levels->low, scene.name,
                          scene.levels->high);
    }
    text += "\n";
  }
  return text;
}

}  // namespace glassbox
