// Loads a scene by the word that a user types.
#pragma once

#include <string>

#include <glassbox/base/error.h>
#include <glassbox/mesh/limits.h>
#include <glassbox/mesh/scene.h>

namespace glassbox {

// A word without slash and dot is a built-in scene ("teapot", "teapot:32"; builtin/scenes.h lists
// them). Anything else is a path, read according to its extension: .gltf, .glb, .obj or .ply, in
// upper or lower case. To load a file in the current directory whose name could be taken for a
// built-in scene, write ./ before it; its extension must be one of these. Errors: unknown built-in
// scene (naming the most similar one), unknown extension, missing or unreadable file, and the
// errors of the loaders.
Result<Scene> load_scene(const std::string& name_or_path, const LoadLimits& limits = {});

// Whether load_scene() reads this path as glTF.
bool is_gltf_name(const std::string& path);

}  // namespace glassbox
