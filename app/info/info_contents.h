// What `info` says of a glTF file beside the scene that is drawn from it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include <glassbox/mesh/gltf/contents.h>

namespace glassbox::app {

// Adds "animations", "skins", "primitives" (with the file's vertex attributes and morph targets) and "textures".
void add_contents(const GltfContents& contents, nlohmann::ordered_json& json);

// Animations, skins, primitives and textures in lines; primitives of the same attributes together.
std::string contents_text(const GltfContents& contents);

}  // namespace glassbox::app
