// Lists what a glTF file describes from its JSON, without the loader: an independent check that the
// loader reports all that it leaves out.
#pragma once

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include <glassbox/mesh/scene.h>

namespace glassbox::test {

// The JSON of a .gltf file, or that of the first chunk of a GLB file.
inline nlohmann::json document_of(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (bytes.starts_with("glTF")) {
    std::uint32_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      length |= std::uint32_t(static_cast<unsigned char>(bytes[12 + i])) << (8 * i);
    }
    bytes = bytes.substr(20, length);
  }
  return nlohmann::json::parse(bytes);
}

// A kind of thing that a file describes, and how many of it there are.
struct GltfFeature {
  std::string what;
  std::size_t count = 0;
};

class GltfFeatureReader {
public:
  explicit GltfFeatureReader(const nlohmann::json& document) : document_(document) {
    const json scenes = list("scenes");
    if (!scenes.empty()) {
      for (const json& root : scenes[document.value("scene", 0u)].value("nodes", json::array())) {
        visit(root);
      }
    } else {
      std::set<std::size_t> children;
      for (const json& node : list("nodes")) {
        for (const json& child : node.value("children", json::array()))
          children.insert(child.get<std::size_t>());
      }
      for (std::size_t i = 0; i < list("nodes").size(); ++i) {
        if (!children.contains(i)) visit(i);
      }
    }
  }

  std::vector<GltfFeature> features() {
    for (const std::size_t mesh : meshes_) read_mesh(mesh);
    for (const std::size_t material : materials_) read_material(list("materials")[material]);
    count("animation", list("animations").size());
    count("skin", skins_.size());
    count("camera", cameras_);
    const std::size_t scenes = list("scenes").size();
    count("other scene", scenes > 0 ? scenes - 1 : 0);
    count("mesh elsewhere", list("meshes").size() - meshes_.size());
    read_extensions(document_);
    std::vector<GltfFeature> all;
    for (const auto& [what, n] : counts_) all.push_back({what, n});
    return all;
  }

private:
  using json = nlohmann::json;

  json list(const char* name) const { return document_.value(name, json::array()); }
  void count(const std::string& what, std::size_t n = 1) {
    if (n > 0) counts_[what] += n;
  }

  void visit(std::size_t index) {
    const json node = list("nodes")[index];
    if (node.contains("mesh")) {
      meshes_.insert(node["mesh"].get<std::size_t>());
      if (node.contains("skin")) {
        skins_.insert(node["skin"].get<std::size_t>());
        skinned_.insert(node["mesh"].get<std::size_t>());
      }
    }
    cameras_ += node.contains("camera");
    for (const json& child : node.value("children", json::array())) visit(child);
  }

  void read_mesh(std::size_t mesh) {
    for (const json& primitive : list("meshes")[mesh]["primitives"]) {
      json material = json::object();
      if (primitive.contains("material")) {
        materials_.insert(primitive["material"].get<std::size_t>());
        material = list("materials")[primitive["material"].get<std::size_t>()];
      }
      for (const auto& [name, accessor] : primitive["attributes"].items()) {
        if (!is_read(name, material, skinned_.contains(mesh))) count("attribute " + name);
      }
      std::set<std::string> moved;
      for (const json& target : primitive.value("targets", json::array())) {
        for (const auto& [name, accessor] : target.items()) moved.insert(name);
      }
      for (const std::string& name : moved) {
        if (name != "POSITION" && name != "NORMAL") {
          count("attribute " + name + " of morph targets");
        }
      }
    }
  }

  static bool is_read(const std::string& name, const json& material, bool skinned) {
    if (name == "POSITION" || name == "NORMAL" || name == "COLOR_0") return true;
    if (name == "JOINTS_0" || name == "WEIGHTS_0") return skinned;
    const json pbr = material.value("pbrMetallicRoughness", json::object());
    std::size_t set = 0;
    if (material.contains("emissiveTexture"))
      set = material["emissiveTexture"].value("texCoord", 0u);
    if (pbr.contains("baseColorTexture")) set = pbr["baseColorTexture"].value("texCoord", 0u);
    return name == "TEXCOORD_" + std::to_string(set);
  }

  void read_material(const json& material) {
    const json pbr = material.value("pbrMetallicRoughness", json::object());
    if (pbr.contains("baseColorTexture")) count("base colour texture");
    if (material.value("extensions", json::object()).contains("KHR_materials_unlit")) return;
    if (material.contains("normalTexture")) count("normal texture");
    if (material.contains("occlusionTexture")) count("occlusion texture");
    if (pbr.contains("metallicRoughnessTexture")) count("metallic-roughness texture");
    const json factor = material.value("emissiveFactor", json{0, 0, 0});
    if (factor == json{0, 0, 0}) return;
    count("emission");
    if (material.contains("emissiveTexture")) count("emissive texture");
  }

  void read_extensions(const json& value) {
    if (value.is_array()) {
      for (const json& item : value) read_extensions(item);
    }
    if (!value.is_object()) return;
    for (const auto& [name, member] : value.items()) {
      if (name == "extras") continue;
      if (name == "extensions") {
        for (const auto& [extension, described] : member.items()) count("extension " + extension);
      }
      read_extensions(member);
    }
  }

  const json& document_;
  std::set<std::size_t> meshes_, materials_, skins_, skinned_;
  std::size_t cameras_ = 0;
  std::map<std::string, std::size_t> counts_;
};

inline std::vector<GltfFeature> gltf_features_of(const nlohmann::json& document) {
  return GltfFeatureReader(document).features();
}

// Whether the scene has as many of them as the file, or a warning gives their name and count.
inline bool is_drawn_or_warned_about(const GltfFeature& feature, const Scene& scene) {
  const auto named = [&](const std::string& part) {
    return std::ranges::any_of(scene.warnings, [&](const std::string& warning) {
      return warning.find(part) != std::string::npos;
    });
  };
  const std::string n = std::to_string(feature.count), s = feature.count == 1 ? "" : "s";
  const auto materials_with = [&](auto&& has) {
    return std::size_t(std::ranges::count_if(scene.materials, has));
  };
  if (feature.what == "base colour texture" || feature.what == "emissive texture") {
    const bool base = feature.what == "base colour texture";
    return feature.count == materials_with([&](const Material& m) {
             return (base ? m.texture : m.emission_texture).has_value();
           });
  }
  if (feature.what == "emission") return feature.count <= materials_with(emits_light);
  if (feature.what.ends_with(" texture")) {
    return named(feature.what + "s are not drawn (" + n + " material" + s + ")");
  }
  if (feature.what.starts_with("attribute ")) {
    return named(feature.what.substr(10) + " (" + n + " primitive" + s + ")");
  }
  if (feature.what == "animation") return named(n + " animation" + s);
  if (feature.what == "skin")
    return named(n + " skin" + s + (feature.count == 1 ? " is drawn" : " are drawn"));
  if (feature.what == "camera") {
    return scene.cameras.size() == feature.count && (feature.count == 1 || named(n + " cameras"));
  }
  if (feature.what == "other scene")
    return named("does not contain these parts of the file: " + n + " scene");
  if (feature.what == "mesh elsewhere") return named(n + " mesh");
  static const std::set<std::string> kDrawn{
      "KHR_lights_punctual", "KHR_materials_emissive_strength", "KHR_materials_unlit",
      "KHR_mesh_quantization", "KHR_texture_transform"};
  const std::string extension = feature.what.substr(std::string("extension ").size());
  return kDrawn.contains(extension) || named("'" + extension + "' is not supported");
}

}  // namespace glassbox::test
