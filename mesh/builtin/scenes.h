// The built-in scenes, by name.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>

namespace glassbox {

// The range of tessellation levels that a scene accepts, as in `teapot:32`.
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

// The scene with this name, or nullptr. A level after a colon is ignored.
const BuiltinScene* find_builtin(std::string_view name_and_level);

// The name among all built-in scenes with the fewest edits (insertions, deletions, replacements)
// from `name`, case ignored; absent if more than two edits are needed.
std::optional<std::string_view> nearest_builtin(std::string_view name);

// Makes the scene "teapot" or "teapot:32". An unknown name, a level out of range, or a level for a
// scene without levels is an error.
Result<Scene> make_builtin(std::string_view name_and_level);

// The names of all built-in scenes as a list for messages: "teapot, cube, ...".
std::string list_builtins();

}  // namespace glassbox
