// Reads glTF 2.0 and GLB files.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include <glassbox/base/error.h>
#include <glassbox/mesh/limits.h>
#include <glassbox/mesh/scene.h>

namespace glassbox {

// Reads the default scene of a .gltf or .glb file (the first scene if the file names no default,
// every root node if there are no scenes). Morph targets have their default weights, skins the pose
// of their nodes. Features of the file that the scene does not have are named in Scene::warnings,
// one line for each kind (missing_features.h).
//
// Metallic-roughness materials become Blinn-Phong ones:
//   specular  = mix(0.2, base colour, metallic) * (1 - roughness)^2
//   shininess = round(2 / max(roughness, 0.1)^4 - 2), kept within 4 .. 256
//   emission  = emissive factor * strength (KHR_materials_emissive_strength)
//
// The file may be hostile: everything that is read is checked against the bytes that exist,
// external files are read only from the file's own directory, and memory use is proportional to the
// files read, within `limits`. Errors name the file, the place in it, the cause and a remedy. A
// scene with nothing to draw is an error.
Result<Scene> load_gltf(const std::string& path, const LoadLimits& limits = {});

// Reads a glTF file in memory. External files are searched in `directory`; "" means that there are
// none.
Result<Scene> load_gltf_memory(std::span<const std::byte> bytes, const std::string& directory,
                               const LoadLimits& limits = {});

}  // namespace glassbox
