// The SCENE of a command line: a file, a built-in scene, or "-" for standard input.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/mesh/limits.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::app {

class Progress;

// What --help says of it.
inline constexpr const char* kSceneHelp =
    "a file (glTF, GLB, OBJ, PLY), a built-in scene, or -: standard input";

// Standard input has the limits of a file. It is read once, to its end; where it is a terminal, that is an error.
Result<Scene> load_asked_scene(const std::string& word, const LoadLimits& limits = {});

// The same, and the bytes that came from standard input; none of files and built-in scenes.
struct SceneAndBytes {
  Scene scene;
  std::vector<std::byte> bytes;
};
Result<SceneAndBytes> load_scene_and_bytes(const std::string& word, const LoadLimits& limits = {});

// Loads it as the phase "loading" of a command's progress, and says the warnings about it there.
Result<Scene> load_asked_scene(const std::string& word, Progress& progress,
                               const LoadLimits& limits = {});

// What a line says of the scene: "standard input" for "-", else the word itself.
std::string scene_title(const std::string& word);

// What outputs are named after: "duck" of "models/duck.glb", "teapot" of "teapot:32", "stdin" of "-".
std::string scene_stem(const std::string& word);

}  // namespace glassbox::app
