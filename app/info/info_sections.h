// The report of `glassbox info` on the parts of a glTF file that are not in the scene drawn from
// it.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <nlohmann/json_fwd.hpp>

#include <glassbox/base/error.h>
#include <glassbox/mesh/gltf/contents.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::app {

// Adds "animations", "skins", "primitives" (with the file's vertex attributes and morph targets)
// and "textures".
void add_contents(const GltfContents& contents, nlohmann::ordered_json& json);

// Animations, skins, primitives and textures as text, one per line; primitives with the same
// attributes are on one line.
std::string contents_text(const GltfContents& contents);

// The report of `glassbox info` on a layered depth image.

// Whether the file begins like a layered depth image; false if it cannot be read.
bool is_layer_file(const std::string& file);

struct LayersInfo {
  std::string text;
  nlohmann::ordered_json json;
};
Result<LayersInfo> layers_info(const std::string& file);

// Warnings of `glassbox info` about numerical errors that would be visible in the usual view.
// Nothing is drawn.

// One line per warning, for the view that `glassbox render SCENE` draws: the scene's first camera,
// or else the whole scene framed. None if there is no such view.
std::vector<std::string> numerical_warnings(const Scene& scene);

}  // namespace glassbox::app
