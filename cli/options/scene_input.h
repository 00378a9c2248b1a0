// The argument SCENE of a command line: a file, a built-in scene, or "-" for standard input.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/mesh/limits.h>
#include <glassbox/mesh/scene.h>

namespace glassbox {

class Progress;

// The text about SCENE in --help.
inline constexpr const char* kSceneHelp =
    "a file (glTF, GLB, OBJ, PLY), a built-in scene, or -: standard input";

// All bytes of standard input. An error if it is a terminal, or has more than `max_bytes`.
Result<std::vector<std::byte>> read_standard_input(std::uint64_t max_bytes);

// Loads the scene. Standard input has the same limits as a file and is read once, to its end. It is
// an error if it is a terminal.
Result<Scene> load_scene_argument(const std::string& word, const LoadLimits& limits = {});

// A scene, with the bytes that came from standard input; no bytes for files and built-in scenes.
struct SceneAndBytes {
  Scene scene;
  std::vector<std::byte> bytes;
};
Result<SceneAndBytes> load_scene_and_bytes(const std::string& word, const LoadLimits& limits = {});

// Loads the scene as the phase "loading" of a command's progress, and prints its warnings there.
Result<Scene> load_scene_argument(const std::string& word, Progress& progress,
                                  const LoadLimits& limits = {});

// The scene's name in a report: "standard input" for "-", else the word itself.
std::string scene_title(const std::string& word);

// The name from which the default names of output files are made: "duck" for "models/duck.glb",
// "teapot" for "teapot:32", "stdin" for "-".
std::string scene_stem(const std::string& word);

}  // namespace glassbox
