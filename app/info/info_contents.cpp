#include "app/info/info_contents.h"

#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>

namespace glassbox::app {

namespace {

using Json = nlohmann::ordered_json;

std::string attribute_names(const GltfContents::Primitive& primitive) {
  std::vector<std::string> names;
  for (const std::string& name : primitive.attributes) names.push_back(printable(name));
  return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

// The primitives by attributes and number of morph targets, with the number of primitives in each
// group.
std::string primitives_text(const GltfContents& contents) {
  std::map<std::pair<std::string, std::size_t>, std::size_t> groups;
  for (const GltfContents::Primitive& primitive : contents.primitives) {
    ++groups[{attribute_names(primitive), primitive.morph_targets}];
  }
  std::string text;
  for (const auto& [same, count] : groups) {
    const auto& [attributes, targets] = same;
    text += fmt::format("  {} in the file: {}{}\n", counted(count, "primitive"), attributes,
                        targets > 0 ? ", " + counted(targets, "morph target") : "");
  }
  return text;
}

std::string use_text(const GltfContents::TextureUse& use) {
  return fmt::format("{} of {}{}", use.what, counted(use.materials, "material"),
                     use.drawn ? "" : " (not drawn)");
}

std::string texture_text(const GltfContents::Texture& texture) {
  const std::string size =
      texture.width > 0 ? fmt::format("{} x {}", texture.width, texture.height) : "of unknown size";
  std::vector<std::string> uses;
  for (const GltfContents::TextureUse& use : texture.uses) uses.push_back(use_text(use));
  return size + ", " + (uses.empty() ? "unused" : fmt::format("{}", fmt::join(uses, ", ")));
}

}  // namespace

void add_contents(const GltfContents& contents, Json& json) {
  json["animations"] = Json::array();
  for (const auto& animation : contents.animations) {
    json["animations"].push_back({{"name", animation.name}, {"channels", animation.channels}});
  }
  json["skins"] = Json::array();
  for (const auto& skin : contents.skins) {
    json["skins"].push_back({{"name", skin.name}, {"joints", skin.joints}});
  }
  json["primitives"] = Json::array();
  for (const auto& primitive : contents.primitives) {
    json["primitives"].push_back({{"mesh", primitive.mesh},
                                  {"mesh_name", primitive.mesh_name},
                                  {"primitive", primitive.primitive},
                                  {"attributes", primitive.attributes},
                                  {"morph_targets", primitive.morph_targets}});
  }
  json["textures"] = Json::array();
  for (const auto& texture : contents.textures) {
    Json uses = Json::array();
    for (const auto& use : texture.uses) {
      uses.push_back({{"use", use.what}, {"materials", use.materials}, {"drawn", use.drawn}});
    }
    json["textures"].push_back({{"name", texture.name},
                                {"width", texture.width},
                                {"height", texture.height},
                                {"uses", uses}});
  }
}

std::string contents_text(const GltfContents& contents) {
  std::string text = primitives_text(contents);
  for (std::size_t i = 0; i < contents.textures.size(); ++i) {
    text += fmt::format("  texture {} '{}': {}\n", i, printable(contents.textures[i].name),
                        texture_text(contents.textures[i]));
  }
  for (std::size_t i = 0; i < contents.animations.size(); ++i) {
    const auto& animation = contents.animations[i];
    text += fmt::format("  animation {} '{}': {}\n", i, printable(animation.name),
                        counted(animation.channels, "channel"));
  }
  for (std::size_t i = 0; i < contents.skins.size(); ++i) {
    const auto& skin = contents.skins[i];
    text +=
        fmt::format("  skin {} '{}': {}\n", i, printable(skin.name), counted(skin.joints, "joint"));
  }
  return text;
}

}  // namespace glassbox::app
