// The scenes that come with the program, by name.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>

namespace glassbox {

// How finely a scene may be tessellated: `teapot:32`.
struct LevelRange {
  int low, usual, high;
};

struct BuiltinScene {
  std::string_view name;
  std::string_view description;      // one line
  std::optional<LevelRange> levels;  // absent: the scene takes no level
  Scene (*make)(int level);
};

std::span<const BuiltinScene> builtin_scenes();

// The scene with this name, or nullptr. A level after a colon is not looked at.
const BuiltinScene* find_builtin(std::string_view name_and_level);

// The name among all built-in scenes that is fewest edits (insertions, deletions, replacements) away from `name`,
// case ignored; absent if that takes more than two edits.
std::optional<std::string_view> nearest_builtin(std::string_view name);

// "teapot" or "teapot:32". An unknown name, a level out of range or one that the scene does not take is an error.
Result<Scene> make_builtin(std::string_view name_and_level);

// "teapot, cube, ..." for messages.
std::string list_builtins();

}  // namespace glassbox
