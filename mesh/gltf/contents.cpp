#include <glassbox/mesh/gltf/contents.h>

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <new>
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
  if (image.contains("uri")) {
    const auto bytes = asset.resources.read(image["uri"].get_ref<const std::string&>());
    return bytes ? find_image_size(**bytes) : std::nullopt;
  }
  if (!image.contains("bufferView")) return std::nullopt;
  const auto bytes = view_bytes(asset, image["bufferView"].get<std::size_t>());
  return bytes ? find_image_size(*bytes) : std::nullopt;
}

GltfContents::TextureUse& use_of(GltfContents::Texture& texture, const std::string& what) {
  const auto known = std::ranges::find(texture.uses, what, &GltfContents::TextureUse::what);
  if (known != texture.uses.end()) return *known;
  return texture.uses.emplace_back(GltfContents::TextureUse{what, 0, false});
}

struct MaterialTextures {
  const json& material;
  bool drawn;  // the scene that is drawn uses the material
  GltfContents& contents;

  void add(const json& holder, const char* member, const char* what, bool shown) const {
    if (!holder.contains(member)) return;
    auto& use = use_of(contents.textures[holder[member]["index"].get<std::size_t>()], what);
    ++use.materials;
    use.drawn = use.drawn || (drawn && shown);
  }
  // As that of the base colour, where there is one: otherwise the emission is left out (materials.h).
  bool has_same_coordinates(const json& pbr) const {
    if (!pbr.contains("baseColorTexture") || !material.contains("emissiveTexture")) return true;
    json infos[] = {pbr["baseColorTexture"], material["emissiveTexture"]};
    for (json& info : infos) {
      info.erase("index");
      if (!info.contains("texCoord")) info["texCoord"] = 0u;
    }
    return infos[0] == infos[1];
  }
  void add_all() const {
    const json pbr = material.value("pbrMetallicRoughness", json::object());
    const bool unlit = material.value("extensions", json::object()).contains("KHR_materials_unlit");
    const json factor = material.value("emissiveFactor", json::array());
    bool emits = false;
    for (const json& channel : factor) emits = emits || channel.get<double>() != 0;
    add(pbr, "baseColorTexture", "base colour", true);
    add(material, "emissiveTexture", "emission", emits && !unlit && has_same_coordinates(pbr));
    add(pbr, "metallicRoughnessTexture", "metallic and roughness", false);
    add(material, "normalTexture", "normals", false);
    add(material, "occlusionTexture", "occlusion", false);
  }
};

void list_textures(Asset& asset, const std::vector<bool>& used, GltfContents& contents) {
  for (const json& described : asset.document.value("textures", json::array())) {
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
    MaterialTextures{asset.document["materials"][i], used[i], contents}.add_all();
  }
}

// ---- the others ----

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
  const auto with_file = [&](Error error) {
    error.file = path;
    return tl::unexpected(std::move(error));
  };
  try {
    const auto bytes = read_whole_file(path, limits.max_file_bytes);
    if (!bytes) return with_file(bytes.error());
    const std::string directory = std::filesystem::path(path).parent_path().string();
    auto asset = open_asset(*bytes, directory.empty() ? "." : directory, limits);
    if (!asset) return with_file(asset.error());
    auto contents = list(*asset);
    if (!contents) return with_file(contents.error());
    return contents;
  } catch (const std::bad_alloc&) {
    return with_file(
        {"", "", "there is not enough memory for it", "close other programs, or reduce the scene"});
  }
}

}  // namespace glassbox
