#include <glassbox/mesh/gltf/contents.h>

#include <algorithm>
#include <optional>

#include <glassbox/images/decode.h>
#include <glassbox/mesh/gltf/asset.h>
#include <glassbox/mesh/gltf/materials.h>
#include <glassbox/mesh/gltf/nodes.h>
#include <glassbox/mesh/gltf/text.h>

namespace glassbox {
namespace {

using namespace gltf;
using nlohmann::json;

std::string name_of(const json& described) {
  return described.value("name", std::string());
}

// ---- textures ----

std::optional<ImageSize> size_of(Asset& asset, const json& image) {
  const auto file = image_file(asset, image);
  return file ? find_image_size(file->bytes) : std::nullopt;
}

GltfContents::TextureUse& use_of(GltfContents::Texture& texture, const std::string& what) {
  const auto known = std::ranges::find(texture.uses, what, &GltfContents::TextureUse::what);
  if (known != texture.uses.end()) return *known;
  return texture.uses.emplace_back(GltfContents::TextureUse{what, 0, false});
}

struct MaterialTextures {
  const tinygltf::Material& described;
  const json& material;
  const json& textures;  // the textures of the file
  bool drawn;            // whether the drawn scene uses the material
  GltfContents& contents;

  void add(const json& holder, const char* member, const char* what, bool shown) const {
    if (!holder.contains(member)) return;
    const auto index = holder[member]["index"].get<std::size_t>();
    auto& use = use_of(contents.textures[index], what);
    ++use.materials;
    use.drawn = use.drawn || (drawn && shown && textures[index].contains("source"));
  }
  void add_all() const {
    const json pbr = material.value("pbrMetallicRoughness", json::object());
    add(pbr, "baseColorTexture", "base colour", true);
    add(material, "emissiveTexture", "emission",
        shows_emission_texture(described, material, textures));
    add(pbr, "metallicRoughnessTexture", "metallic and roughness", false);
    add(material, "normalTexture", "normals", false);
    add(material, "occlusionTexture", "occlusion", false);
  }
};

void list_textures(Asset& asset, const std::vector<bool>& used, GltfContents& contents) {
  const json textures = asset.document.value("textures", json::array());
  for (const json& described : textures) {
    GltfContents::Texture& texture = contents.textures.emplace_back();
    texture.name = name_of(described);
    if (!described.contains("source")) continue;
    const json& image = asset.document["images"][described["source"].get<std::size_t>()];
    if (texture.name.empty()) texture.name = name_of(image);
    if (const auto size = size_of(asset, image)) {
      texture.width = size->width;
      texture.height = size->height;
    }
  }
  for (std::size_t i = 0; i < used.size(); ++i) {
    MaterialTextures{asset.model.materials[i], asset.document["materials"][i], textures, used[i],
                     contents}
        .add_all();
  }
}

// ---- primitives, animations and skins ----

void list_primitives(const Asset& asset, GltfContents& contents) {
  const auto& meshes = asset.model.meshes;
  for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh) {
    for (std::size_t i = 0; i < meshes[mesh].primitives.size(); ++i) {
      const tinygltf::Primitive& primitive = meshes[mesh].primitives[i];
      auto& listed = contents.primitives.emplace_back();
      listed.mesh = mesh;
      listed.primitive = i;
      listed.mesh_name = meshes[mesh].name;
      for (const auto& [name, accessor] : primitive.attributes) listed.attributes.push_back(name);
      listed.morph_targets = primitive.targets.size();
    }
  }
}

Result<GltfContents> list(Asset& asset) {
  Scene scene;
  const auto tree = place_nodes(asset, scene);
  if (!tree) return tl::unexpected(tree.error());
  GltfContents contents;
  for (const json& animation : asset.document.value("animations", json::array())) {
    const std::size_t channels = animation.value("channels", json::array()).size();
    contents.animations.push_back({name_of(animation), channels});
  }
  for (const tinygltf::Skin& skin : asset.model.skins) {
    contents.skins.push_back({skin.name, skin.joints.size()});
  }
  list_primitives(asset, contents);
  list_textures(asset, used_materials(asset, *tree), contents);
  return contents;
}

}  // namespace

Result<GltfContents> list_gltf(const std::string& path, const LoadLimits& limits) {
  return naming_file(path, [&]() -> Result<GltfContents> {
    auto asset = open_asset(path, limits);
    if (!asset) return tl::unexpected(asset.error());
    return list(*asset);
  });
}

Result<GltfContents> list_gltf_memory(std::span<const std::byte> bytes,
                                      const std::string& directory, const LoadLimits& limits) {
  return naming_file("", [&]() -> Result<GltfContents> {
    auto asset = open_asset(bytes, directory, limits);
    if (!asset) return tl::unexpected(asset.error());
    return list(*asset);
  });
}

}  // namespace glassbox
