#include <glassbox/mesh/builtin/scenes.h>

#include <charconv>

#include <glassbox/base/closest_word.h>
#include <glassbox/mesh/builtin/checker.h>
#include <glassbox/mesh/builtin/cube.h>
#include <glassbox/mesh/builtin/depth_ladder.h>
#include <glassbox/mesh/builtin/f_glyph.h>
#include <glassbox/mesh/builtin/forest.h>
#include <glassbox/mesh/builtin/room.h>
#include <glassbox/mesh/builtin/sphere.h>
#include <glassbox/mesh/builtin/teapot.h>
#include <glassbox/mesh/builtin/thicket.h>

namespace glassbox {
namespace {

constexpr BuiltinScene kScenes[] = {
    {"teapot", "Newell's teapot, 32 Bezier patches at any level of detail",
     LevelRange{1, kTeapotLevel, kMaxTeapotLevel}, [](int level) { return make_teapot(level); }},
    {"cube", "a cube of side 2, every face in its own colour", std::nullopt,
     [](int) { return make_cube(); }},
    {"sphere", "a smooth ball of radius 1, at any level of detail",
     LevelRange{2, kSphereLevel, kMaxSphereLevel}, [](int level) { return make_sphere(level); }},
    {"forest", "150 thin trees, near and far, for stereo pictures", std::nullopt,
     [](int) { return make_forest(); }},
    {"room", "a furnished room from inside, textured, lit by a lamp", std::nullopt,
     [](int) { return make_room(); }},
    {"checker", "a checkered floor to the horizon, for texture filtering", std::nullopt,
     [](int) { return make_checker(); }},
    {"thicket", "twigs whose leaves are cut out by alpha", std::nullopt,
     [](int) { return make_thicket(); }},
    {"f-glyph", "a thick letter F, which shows if a picture is mirrored or turned", std::nullopt,
     [](int) { return make_f_glyph(); }},
    {"depth-ladder", "nearly coplanar squares at distances from 1 to 2^19, for depth formats",
     std::nullopt, [](int) { return make_depth_ladder(); }},
};

std::string_view base_name(std::string_view name_and_level) {
  return name_and_level.substr(0, name_and_level.find(':'));
}

Result<int> read_level(const BuiltinScene& scene, std::string_view name_and_level) {
  const std::size_t colon = name_and_level.find(':');
  if (colon == std::string_view::npos) return scene.levels ? scene.levels->usual : 0;
  const std::string place(name_and_level), name(scene.name);
  if (!scene.levels) {
    return fail(place, "the built-in scene '" + name + "' has no levels of detail",
                "write '" + name + "'");
  }
  const std::string_view digits = name_and_level.substr(colon + 1);
  int level = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), level);
  const bool read = error == std::errc() && end == digits.data() + digits.size();
  if (!read || level < scene.levels->low || level > scene.levels->high) {
    return fail(place,
                "the level of '" + name + "' must be a whole number from " +
                    std::to_string(scene.levels->low) + " to " + std::to_string(scene.levels->high),
                "write for example '" + name + ":" + std::to_string(scene.levels->usual) + "'");
  }
  return level;
}

}  // namespace

std::span<const BuiltinScene> builtin_scenes() {
  return kScenes;
}

const BuiltinScene* find_builtin(std::string_view name_and_level) {
  const std::string_view name = base_name(name_and_level);
  for (const BuiltinScene& scene : kScenes) {
    if (scene.name == name) return &scene;
  }
  return nullptr;
}

std::optional<std::string_view> nearest_builtin(std::string_view name) {
  constexpr std::size_t kMaxEdits = 2, kLongestWord = 64;
  if (name.size() > kLongestWord) return std::nullopt;
  std::optional<std::string_view> nearest;
  std::size_t fewest = kMaxEdits + 1;
  for (const BuiltinScene& scene : kScenes) {
    const std::size_t edits = edit_distance(name, scene.name);
    if (edits < fewest) {
      fewest = edits;
      nearest = scene.name;
    }
  }
  return nearest;
}

Result<Scene> make_builtin(std::string_view name_and_level) {
  const BuiltinScene* scene = find_builtin(name_and_level);
  if (scene == nullptr) {
    const std::string name(base_name(name_and_level));
    const auto nearest = nearest_builtin(name);
    return fail(name, "there is no such built-in scene",
                nearest ? "did you mean '" + std::string(*nearest) + "'?"
                        : "built-in scenes are " + list_builtins());
  }
  const Result<int> level = read_level(*scene, name_and_level);
  if (!level) return tl::unexpected(level.error());
  return scene->make(*level);
}

std::string list_builtins() {
  std::string list;
  for (const BuiltinScene& scene : kScenes) {
    if (!list.empty()) list += ", ";
    list += scene.name;
  }
  return list;
}

}  // namespace glassbox
