#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "app/info/info_sections.h"
#include "app/why/verdict_text.h"
#include "cli/options/picture_options.h"
#include "study/commands/stiffness/report.h"
#include "study/stiffness/stiffness.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>
#include <glassbox/pipeline/divide.h>
#include <glassbox/pipeline/viewport.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/staged/vertex_stage.h>
#include <glassbox/render/trace/depth_fights.h>
#include <glassbox/render/trace/numbering.h>

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

namespace {

// Larger scenes are not checked, because the check takes about four microseconds per triangle.
constexpr std::uint64_t kMaxTriangles = 200'000;
// The check is also left out if the triangles' bounding boxes have more pixels together: it takes
// about half a microsecond per fragment, and up to half of a bounding box's pixels are fragments.
constexpr double kMaxBoxPixels = 1 << 25;

// The number of the picture's pixels in a triangle's bounding box; all pixels if a corner is not in
// front of the eye.
double box_pixels(const Draw& draw, const Triangle& triangle, const Viewport& viewport) {
  float left = viewport.right, right = viewport.left, top = viewport.bottom, bottom = viewport.top;
  for (const std::uint32_t corner : triangle.corners) {
    const auto clip = project_vertex(draw, draw.mesh->corners[corner].position);
    if (!(clip.w > 0)) return double(viewport.width()) * double(viewport.height());
    const auto at = to_screen(divide(clip), viewport).position;
    left = std::min(left, std::max(at.x, viewport.left));
    right = std::max(right, std::min(at.x, viewport.right));
    top = std::min(top, std::max(at.y, viewport.top));
    bottom = std::max(bottom, std::min(at.y, viewport.bottom));
  }
  return std::max(0.0, double(right - left)) * std::max(0.0, double(bottom - top));
}

double box_pixels(const Scene& scene, const View& view) {
  const PreparedScene prepared = prepare_scene(scene, Transfer::kSrgb);
  const DrawList list = make_draw_list(scene, prepared, view);
  double sum = 0;
  for (const Draw& draw : list.draws) {
    for (const Triangle& triangle : draw.triangulation->triangles)
      sum += box_pixels(draw, triangle, view.viewport);
  }
  return sum;
}

std::vector<std::string> not_asked(const std::string& because) {
  return {
      fmt::format("the error bounds of the default view were not computed, because {}; glassbox "
                  "study stiffness computes them",
                  because)};
}

}  // namespace

std::vector<std::string> numerical_warnings(const Scene& scene) {
  const std::uint64_t triangles = count_triangles(scene);
  if (triangles > kMaxTriangles)
    return not_asked("the scene has " + counted(triangles, "triangle"));
  const PictureOptions usual;
  const Result<ChosenView> chosen = choose_view(scene, usual);
  if (!chosen) return {};
  if (!(box_pixels(scene, chosen->view) <= kMaxBoxPixels))
    return not_asked("too many of its triangles cover each other");
  std::vector<std::string> lines = study::stiffness_warnings(
      scene,
      study::stiffness_of(scene, chosen->view, usual.settings, study::up_of(scene, usual.camera)));
  const std::vector<DepthFight> fights = depth_fights(scene, chosen->view, usual.settings);
  if (fights.empty()) return lines;
  lines.push_back(fight_text(scene, chosen->view, usual.settings.depth, fights.front()));
  if (fights.size() > 1) {
    lines.back() += fmt::format(" {} do the same.", counted(fights.size() - 1, "other pair"));
  }
  return lines;
}

}  // namespace glassbox::app
