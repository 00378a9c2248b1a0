// A scene from bytes that are no file: what came through a pipe.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include <glassbox/base/error.h>
#include <glassbox/mesh/limits.h>
#include <glassbox/mesh/scene.h>

namespace glassbox {

enum class SceneFormat { kGlb, kGltf, kObj, kPly };

// By how the bytes begin: GLB and PLY have a magic word, glTF is a JSON object, and any other text counts as OBJ. None
// for what is no text.
std::optional<SceneFormat> format_of(std::span<const std::byte> bytes);

// There is no directory beside the bytes, so nothing else is read: glTF that names external files is an error, material
// libraries of OBJ are a warning.
Result<Scene> load_scene_memory(std::span<const std::byte> bytes, const LoadLimits& limits = {});

}  // namespace glassbox
