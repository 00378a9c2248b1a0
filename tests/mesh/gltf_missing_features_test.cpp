// All that a glTF file describes is drawn or named by a warning: one for each kind, with its count.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "tests/images/temporary_directory.h"
#include "tests/mesh/gltf_builder.h"
#include "tests/mesh/gltf_features.h"
#include "tests/support/catch.h"
#include "tests/support/skip.h"

#include <glassbox/mesh/gltf/contents.h>

using namespace glassbox;
using namespace glassbox::test;

namespace {

std::vector<std::string> warnings_of(const GltfBuilder& builder) {
  const auto scene = builder.load();
  INFO(error_of(scene));
  REQUIRE(scene);
  return scene->warnings;
}

// Triangles with `materials` copies of this material, and a texture without an image that it may
// refer to.
GltfBuilder textured(const json& material, int materials) {
  GltfBuilder b;
  b.document["textures"] = json::array({json::object()});
  for (int i = 0; i < materials; ++i) {
    b.triangle()["material"] = i;
    b.document["materials"].push_back(material);
  }
  return b;
}

// Checks that the scene has exactly these warnings, in any order.
void check_warnings(const GltfBuilder& builder, std::multiset<std::string> expected) {
  const auto found = warnings_of(builder);
  CHECK(std::multiset<std::string>(found.begin(), found.end()) == expected);
}

}  // namespace

TEST_CASE("textures that are not drawn are named once for each kind, with the materials counted") {
  const json texture = {{"index", 0}};
  const json material = {{"normalTexture", texture},
                         {"occlusionTexture", texture},
                         {"pbrMetallicRoughness", {{"metallicRoughnessTexture", texture}}}};
  check_warnings(textured(material, 3), {"normal textures are not drawn (3 materials)",
                                         "occlusion textures are not drawn (3 materials)",
                                         "metallic-roughness textures are not drawn (3 materials); "
                                         "the materials' metallic and roughness "
                                         "factors are"});
  json unlit = material;
  unlit["extensions"]["KHR_materials_unlit"] = json::object();
  check_warnings(textured(unlit, 2), {});
  GltfBuilder unused = textured(material, 1);
  unused.document["meshes"][0]["primitives"][0].erase("material");
  check_warnings(unused, {});
}

TEST_CASE("animations are counted, and skins that stand in the pose of their nodes") {
  GltfBuilder b;
  json& primitive = b.triangle();
  primitive["attributes"]["JOINTS_0"] =
      b.accessor(b.view(std::vector<std::uint8_t>(12)), 5121, "VEC4", 3);
  primitive["attributes"]["WEIGHTS_0"] = b.floats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4", 4);
  b.document["skins"] = {{{"joints", json::array({1})}}};
  b.document["nodes"] = {{{"mesh", 0}, {"skin", 0}}, json::object()};
  const json one = json::array({json::object()});
  b.document["animations"] = {{{"channels", one}, {"samplers", one}}, {{"channels", one}}};
  check_warnings(b, {"2 animations are not played: everything is drawn where the file places it",
                     "1 skin is drawn in the pose of its nodes"});
  b.document["nodes"][0].erase("skin");
  b.document.erase("animations");
  check_warnings(b, {"vertex attributes are not drawn: JOINTS_0 (1 primitive), WEIGHTS_0 (1 "
                     "primitive)"});
}

TEST_CASE("vertex attributes that nothing reads are named, with their primitives counted") {
  GltfBuilder b;
  for (int i = 0; i < 2; ++i) {
    json& primitive = b.triangle();
    primitive["attributes"]["TANGENT"] = b.floats(std::vector<float>(12, 0.5f), "VEC4", 4);
    primitive["attributes"]["TEXCOORD_0"] = b.floats({0, 0, 1, 0, 0, 1}, "VEC2", 2);
    primitive["attributes"]["TEXCOORD_1"] = b.floats({0, 0, 1, 0, 0, 1}, "VEC2", 2);
    if (i == 0) primitive["attributes"]["_HEAT"] = b.floats({1, 2, 3}, "SCALAR", 1);
    primitive["targets"] = {{{"TANGENT", primitive["attributes"]["POSITION"]}}};
  }
  check_warnings(b, {"vertex attributes are not drawn: TANGENT (2 primitives), TANGENT of morph "
                     "targets (2 primitives), TEXCOORD_1 (2 primitives), _HEAT (1 primitive)"});
}

TEST_CASE("what stands outside the scene that is drawn is counted, and cameras beside the first") {
  GltfBuilder b;
  b.triangle();
  b.triangle();
  b.document["cameras"] = json::array();
  for (int i = 0; i < 3; ++i) {
    b.document["cameras"].push_back(
        {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}});
  }
  b.document["nodes"].push_back({{"camera", 0}});
  b.document["nodes"].push_back({{"camera", 2}});
  b.document["scenes"] = {{{"nodes", {0, 2, 3}}}, {{"nodes", json::array({1})}}};
  check_warnings(b, {"2 cameras: the first one is used, unless another one is chosen",
                     "the scene that is drawn does not contain these parts of the file: 1 scene, 1 "
                     "node with a mesh, camera or light, 1 mesh, 1 camera"});
}

TEST_CASE("an extension that is not known is named with its places, listed by the file or not") {
  GltfBuilder b;
  b.triangle()["material"] = 0;
  b.document["materials"] = {
      {{"extensions", {{"KHR_materials_clearcoat", {{"clearcoatFactor", 1}}}}}},
      {{"extensions", {{"KHR_materials_clearcoat", json::object()}}},
       {"extras", {{"extensions", {{"mine", 1}}}}}}};
  b.document["extensionsUsed"] = {"KHR_materials_clearcoat", "KHR_xmp"};
  check_warnings(
      b, {"the extension 'KHR_materials_clearcoat' is not supported and was ignored in 2 places",
          "the extension 'KHR_xmp' is not supported and was ignored"});
  b.document.erase("extensionsUsed");
  b.document["materials"].erase(1);
  check_warnings(b, {"the extension 'KHR_materials_clearcoat' is not supported and was ignored in "
                     "one place"});
}

TEST_CASE("what is said of many primitives is said once") {
  GltfBuilder b;
  for (int i = 0; i < 40; ++i) {
    json& primitive = b.triangle();
    primitive["attributes"]["NORMAL"] = b.floats(std::vector<float>(9, 0), "VEC3", 3);
  }
  check_warnings(b, {"mesh 0, primitive 0 and 39 more: normals of length zero were left out (120); "
                     "corners with them are shaded flat"});
}

TEST_CASE(
    "the contents of a file are listed: animations, skins, primitives and textures with uses") {
  GltfBuilder b = textured({{"name", "skin"},
                            {"normalTexture", {{"index", 0}}},
                            {"emissiveTexture", {{"index", 0}}},
                            {"emissiveFactor", {0, 1, 0}}},
                           2);
  b.document["animations"] = {{{"name", "walk"}, {"channels", {json::object(), json::object()}}}};
  b.document["meshes"][0]["primitives"][0].erase("material");
  b.document["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 0}}};
  std::vector<std::uint8_t> header{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n', 0, 0, 0, 13,
                                   'I',  'H', 'D', 'R', 0,    0,    2,    0,    0, 0, 0, 7};
  const std::size_t view = b.view(header);
  b.document["images"] = {{{"name", "tiny"}, {"bufferView", view}}};
  b.document["textures"] = {{{"source", 0}}};
  const TemporaryDirectory folder;
  const std::string path = folder.file("a.glb");
  const Bytes file = b.glb();
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(file.data()), std::streamsize(file.size()));
  const auto contents = list_gltf(path);
  REQUIRE(contents);
  REQUIRE(contents->animations.size() == 1);
  CHECK(contents->animations[0].name == "walk");
  CHECK(contents->animations[0].channels == 2);
  REQUIRE(contents->primitives.size() == 2);
  CHECK(contents->primitives[0].attributes == std::vector<std::string>{"POSITION"});
  CHECK(contents->primitives[0].morph_targets == 1);
  REQUIRE(contents->textures.size() == 1);
  const GltfContents::Texture& texture = contents->textures[0];
  CHECK(texture.name == "tiny");
  CHECK(texture.width == 512);
  CHECK(texture.height == 7);
  REQUIRE(texture.uses.size() == 2);
  CHECK(texture.uses[0].what == "emission");
  CHECK(texture.uses[0].materials == 2);
  CHECK(texture.uses[0].drawn);
  CHECK(texture.uses[1].what == "normals");
  CHECK_FALSE(texture.uses[1].drawn);
}

TEST_CASE("in real files nothing is neither drawn nor named, by an independent reading of them") {
  const std::filesystem::path meshes = std::filesystem::path(GLASSBOX_ASSETS_DIR) / "meshes";
  if (!std::filesystem::is_directory(meshes)) {
    SKIP_TEST("no meshes under " << GLASSBOX_ASSETS_DIR);
  }
  std::size_t files = 0, features = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(meshes)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".gltf" && extension != ".glb") continue;
    const auto scene = load_gltf(entry.path().string());
    if (!scene) continue;  // the loader has reported an error
    ++files;
    const json document = document_of(entry.path());
    for (const GltfFeature& feature : gltf_features_of(document)) {
      ++features;
      CAPTURE(entry.path().string(), feature.what, feature.count, scene->warnings);
      CHECK(is_drawn_or_warned_about(feature, *scene));
    }
    for (const std::string& warning : scene->warnings) {
      CAPTURE(entry.path().string(), warning);
      CHECK(std::ranges::count(scene->warnings, warning) == 1);
    }
  }
  CHECK(files > 50);
  CHECK(features > 10);  // few: most files describe nothing that is not drawn
}
