// Converts materials, textures, samplers and images: from metallic-roughness to Blinn-Phong.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/mesh/gltf/asset.h>
#include <glassbox/mesh/gltf/nodes.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::gltf {

// The map (u, v) -> offset + rotation * (scale * (u, v)) of KHR_texture_transform.
struct TexCoordTransform {
  double matrix[2][3] = {{1, 0, 0}, {0, 1, 0}};
  friend bool operator==(const TexCoordTransform&, const TexCoordTransform&) = default;
};

// How a mesh computes its texture coordinates for a material.
struct TexCoordSource {
  std::uint32_t set = 0;  // the N of TEXCOORD_N
  std::optional<TexCoordTransform> transform;
  bool textured = false;
  friend bool operator==(const TexCoordSource&, const TexCoordSource&) = default;
};

// For each material of the file, whether the scene that is drawn uses it.
std::vector<bool> used_materials(const Asset& asset, const NodeTree& tree);

// Whether a drawn material of the file shows its emissive texture, provided that the texture has an
// image. This depends on what the material says about its emission, and on which texture
// coordinates convert_materials chooses. `textures` are the file's.
bool shows_emission_texture(const tinygltf::Material& described, const nlohmann::json& document,
                            const nlohmann::json& textures);

struct Materials {
  std::vector<TexCoordSource> texcoords;  // one for each of Scene::materials
};

// Fills scene.materials with the file's materials in their order, and "default" after them if a
// drawn primitive names none. Fills scene.textures and scene.images with everything that drawn
// materials need: images that nothing drawn uses are not decoded. A mesh has one table of texture
// coordinates: where the base colour and the emission of a material need different ones, the
// emission is left out (shows_emission_texture).
Result<Materials> convert_materials(Asset& asset, const NodeTree& tree, Scene& scene);

}  // namespace glassbox::gltf
