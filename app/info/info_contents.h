// The report of `glassbox info` on the parts of a glTF file that are not in the scene drawn from
// it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include <glassbox/mesh/gltf/contents.h>

namespace glassbox::app {

// Adds "animations", "skins", "primitives" (with the file's vertex attributes and morph targets)
// and "textures".
void add_contents(const GltfContents& contents, nlohmann::ordered_json& json);

// Animations, skins, primitives and textures, one per line; primitives with the same attributes
// share a line.
std::string contents_text(const GltfContents& contents);

}  // namespace glassbox::app
