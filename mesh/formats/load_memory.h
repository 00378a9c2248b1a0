// A scene from bytes that are not in a file, for example from a pipe.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include <glassbox/base/error.h>
#include <glassbox/mesh/limits.h>
#include <glassbox/mesh/scene.h>

namespace glassbox {

enum class SceneFormat { kGlb, kGltf, kObj, kPly };

// Detects the format from the first bytes: GLB and PLY have a magic word, glTF is a JSON object,
// and any other text is taken for OBJ. Returns none for bytes that are not text.
std::optional<SceneFormat> format_of(std::span<const std::byte> bytes);

// Reads a scene from memory. The bytes have no directory, so no other file is read: glTF that names
// external files is an error, material libraries of OBJ are a warning.
Result<Scene> load_scene_memory(std::span<const std::byte> bytes, const LoadLimits& limits = {});

}  // namespace glassbox
