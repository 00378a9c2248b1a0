// The one way to get a scene by the word that a user types.
#pragma once

#include <string>

#include <glassbox/base/error.h>
#include <glassbox/mesh/limits.h>
#include <glassbox/mesh/scene.h>

namespace glassbox {

// A word without slash and dot is a built-in scene ("teapot", "teapot:32"; builtin/scenes.h lists them); anything else
// is a path, read according to its extension: .gltf, .glb, .obj or .ply, in either case. A file called `teapot` is reached as
// ./teapot, if its name ends in one of these. Errors: unknown built-in (naming the nearest one), unknown extension,
// missing or unreadable file, and what the loaders find.
Result<Scene> load_scene(const std::string& name_or_path, const LoadLimits& limits = {});

// Whether load_scene() reads such a path as glTF.
bool is_gltf_name(const std::string& path);

}  // namespace glassbox
