#include <glassbox/mesh/gltf/missing_features.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include <glassbox/base/counted.h>
#include <glassbox/mesh/gltf/text.h>

namespace glassbox::gltf {
namespace {

using nlohmann::json;

std::string separated(const std::string& before, const std::string& next) {
  return before.empty() ? next : before + ", " + next;
}

// ---- materials ----

void warn_about_textures(Asset& asset, const std::vector<bool>& used) {
  std::size_t normal = 0, occlusion = 0, metallic = 0;
  for (std::size_t i = 0; i < used.size(); ++i) {
    const json& material = asset.document["materials"][i];
    // An unlit material uses its base colour only.
    if (!used[i] || find(material, {"extensions", "KHR_materials_unlit"})) continue;
    normal += material.contains("normalTexture");
    occlusion += material.contains("occlusionTexture");
    metallic += find(material, {"pbrMetallicRoughness", "metallicRoughnessTexture"}) != nullptr;
  }
  const auto name = [&](std::size_t count, const std::string& what, const std::string& instead) {
    if (count > 0) {
      asset.warn(what + " textures are not drawn (" + counted(count, "material") + ")" + instead);
    }
  };
  name(normal, "normal", "");
  name(occlusion, "occlusion", "");
  name(metallic, "metallic-roughness", "; the materials' metallic and roughness factors are");
}

// ---- vertex attributes ----

// For each attribute that is not read, the number of primitives that have it and are drawn without
// it.
using UnreadAttributes = std::map<std::string, std::size_t>;

void find_unread(const tinygltf::Primitive& primitive, std::uint32_t texcoord_set, bool skinned,
                 UnreadAttributes& unread) {
  const std::string texcoords = "TEXCOORD_" + std::to_string(texcoord_set);
  for (const auto& [name, accessor] : primitive.attributes) {
    const bool of_skin = name.starts_with("JOINTS_") || name.starts_with("WEIGHTS_");
    const bool read = name == "POSITION" || name == "NORMAL" || name == "COLOR_0" ||
                      name == texcoords || (of_skin && skinned);
    if (!read) ++unread[name];
  }
  std::map<std::string, bool> moved;
  for (const auto& target : primitive.targets) {
    for (const auto& [name, accessor] : target) {
      if (name != "POSITION" && name != "NORMAL") moved[name] = true;
    }
  }
  for (const auto& [name, any] : moved) ++unread[name + " of morph targets"];
}

void warn_about_attributes(Asset& asset, const NodeTree& tree, const Materials& materials) {
  std::map<int, bool> skinned;  // for each drawn mesh, whether it is drawn with a skin
  for (const std::uint32_t node : tree.drawn) {
    const tinygltf::Node& described = asset.model.nodes[node];
    if (described.mesh < 0) continue;
    bool& any = skinned[described.mesh];
    any = any || described.skin >= 0;
  }
  UnreadAttributes unread;
  for (const auto& [mesh, has_skin] : skinned) {
    for (const tinygltf::Primitive& primitive : asset.model.meshes[std::size_t(mesh)].primitives) {
      const std::size_t material =
          primitive.material < 0 ? materials.texcoords.size() - 1 : std::size_t(primitive.material);
      find_unread(primitive, materials.texcoords[material].set, has_skin, unread);
    }
  }
  constexpr std::size_t kMaxNamed = 16;
  std::string named;
  std::size_t count = 0;
  for (const auto& [name, primitives] : unread) {
    if (count++ < kMaxNamed) {
      named = separated(named, printable(name) + " (" + counted(primitives, "primitive") + ")");
    }
  }
  if (count > kMaxNamed) named += " and " + std::to_string(count - kMaxNamed) + " more";
  if (count > 0) asset.warn("vertex attributes are not drawn: " + named);
}

// ---- animations and skins ----

void warn_about_animations_and_skins(Asset& asset, const NodeTree& tree) {
  const std::size_t animations = asset.document.value("animations", json::array()).size();
  if (animations > 0) {
    asset.warn(counted(animations, "animation is", "animations are") +
               " not played: everything is drawn where the file places it");
  }
  std::vector<bool> drawn(asset.model.skins.size(), false);
  for (const std::uint32_t node : tree.drawn) {
    const tinygltf::Node& described = asset.model.nodes[node];
    if (described.mesh >= 0 && described.skin >= 0) drawn[std::size_t(described.skin)] = true;
  }
  const auto skins = std::size_t(std::ranges::count(drawn, true));
  if (skins > 0) {
    asset.warn(counted(skins, "skin") + (skins == 1 ? " is drawn in the pose of its nodes"
                                                    : " are drawn in the poses of their nodes"));
  }
}

// ---- what is outside the drawn scene ----

// The index of the light of a node, or -1.
int light_of(const json& node) {
  const json* light = find(node, {"extensions", "KHR_lights_punctual", "light"});
  return light != nullptr ? light->get<int>() : -1;
}

// Which entries of each list are referred to by a node of the drawn scene.
struct ReferencedEntries {
  std::vector<bool> meshes, cameras, lights;

  static void mark(std::vector<bool>& list, int index) {
    if (index >= 0) list[std::size_t(index)] = true;
  }
};

void warn_about_unused_entries(Asset& asset, const NodeTree& tree) {
  ReferencedEntries referenced{std::vector<bool>(asset.model.meshes.size()),
                               std::vector<bool>(asset.model.cameras.size()),
                               std::vector<bool>(asset.model.lights.size())};
  std::size_t nodes = 0;
  for (std::size_t i = 0; i < asset.model.nodes.size(); ++i) {
    const tinygltf::Node& node = asset.model.nodes[i];
    const int light = light_of(asset.document["nodes"][i]);
    if (tree.scene_index[i] == kNone) {
      nodes += node.mesh >= 0 || node.camera >= 0 || light >= 0;
      continue;
    }
    ReferencedEntries::mark(referenced.meshes, node.mesh);
    ReferencedEntries::mark(referenced.cameras, node.camera);
    ReferencedEntries::mark(referenced.lights, light);
  }
  std::string named;
  const auto add = [&](std::size_t count, const char* one, const char* many) {
    if (count > 0) named = separated(named, counted(count, one, many));
  };
  const auto missing = [](const std::vector<bool>& list) {
    return std::size_t(std::ranges::count(list, false));
  };
  const std::size_t scenes = asset.model.scenes.size();
  add(scenes > 1 ? scenes - 1 : 0, "scene", "scenes");
  add(nodes, "node with a mesh, camera or light", "nodes with a mesh, camera or light");
  add(missing(referenced.meshes), "mesh", "meshes");
  add(missing(referenced.cameras), "camera", "cameras");
  add(missing(referenced.lights), "light", "lights");
  if (!named.empty())
    asset.warn("the scene that is drawn does not contain these parts of the file: " + named);
}

// A picture shows the first camera if no other one is requested.
void warn_about_cameras(Asset& asset, const Scene& scene) {
  const auto cameras =
      std::ranges::count_if(scene.cameras, [](const Camera& c) { return c.fault.empty(); });
  if (cameras > 1) {
    asset.warn(std::to_string(cameras) +
               " cameras: the first one is used, unless another one is chosen");
  }
}

}  // namespace

void warn_about_missing_features(Asset& asset, const NodeTree& tree, const Materials& materials,
                                 const Scene& scene) {
  warn_about_textures(asset, used_materials(asset, tree));
  warn_about_attributes(asset, tree, materials);
  warn_about_animations_and_skins(asset, tree);
  warn_about_cameras(asset, scene);
  warn_about_unused_entries(asset, tree);
}

}  // namespace glassbox::gltf
