// The contents that glTF files may have, and the scenes that are loaded from them.
#include <array>
#include <cmath>

#include <glassbox/base/trig.h>
#include <glassbox/images/write.h>

#include "tests/mesh/gltf_builder.h"
#include "tests/support/catch.h"

using namespace glassbox;
using namespace glassbox::test;

namespace {

Scene loaded(const GltfBuilder& builder) {
  auto scene = builder.load();
  INFO(error_of(scene));
  REQUIRE(scene);
  return std::move(*scene);
}

std::array<std::uint32_t, 3> face_positions(const Mesh& mesh, std::size_t face) {
  const Corner* c = mesh.corners.data() + mesh.faces[face].first;
  return {c[0].position, c[1].position, c[2].position};
}

// A triangle with three texture coordinates and a material with a one-texel texture.
GltfBuilder textured_triangle(const json& texture_info) {
  GltfBuilder b;
  json& primitive = b.triangle();
  primitive["attributes"]["TEXCOORD_0"] = b.floats({0, 0, 1, 0, 0, 1}, "VEC2", 2);
  primitive["attributes"]["TEXCOORD_1"] = b.floats({.25f, 0, .5f, 0, .75f, 1}, "VEC2", 2);
  primitive["material"] = 0;
  const auto png = encode_png(Image<Rgba8>(1, 1, {10, 20, 30, 40}));
  REQUIRE(png);
  const std::size_t view = b.view(*png);
  b.document["images"] = {{{"bufferView", view}, {"mimeType", "image/png"}}};
  b.document["samplers"] = {
      {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}, {"minFilter", 9985}}};
  b.document["textures"] = {{{"source", 0}, {"sampler", 0}}};
  b.document["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", texture_info}}}}};
  return b;
}

}  // namespace

TEST_CASE("a triangle without indices, normals and material loads as one flat face") {
  GltfBuilder b;
  b.triangle();
  const Scene scene = loaded(b);
  REQUIRE(scene.meshes.size() == 1);
  const Mesh& mesh = scene.meshes[0];
  CHECK(mesh.positions[1] == Point<Object>(1, 0, 0));
  REQUIRE(mesh.faces.size() == 1);
  CHECK(mesh.corners[2] == Corner{2, kNone, kNone, kNone});
  CHECK(scene.instances.size() == 1);
  CHECK(scene.materials.size() == 1);
  CHECK(scene.materials[0].specular == std::array<float, 3>{0, 0, 0});
}

TEST_CASE(
    "every primitive mode gives the shapes of the specification, strips with alternating winding") {
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;
  const auto mesh_of = [](int mode) {
    GltfBuilder b;
    const std::size_t positions =
        b.floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 2, 2, 0, 3, 0, 0}, "VEC3", 3);
    b.primitive({{"attributes", {{"POSITION", positions}}}, {"mode", mode}});
    return loaded(b).meshes[0];
  };
  const auto triangles = [](const Mesh& mesh) {
    Triangles all;
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) all.push_back(face_positions(mesh, i));
    return all;
  };
  const auto lines = [](const Mesh& mesh) {
    std::vector<std::array<std::uint32_t, 2>> all;
    for (const auto& line : mesh.lines) all.push_back({line[0].position, line[1].position});
    return all;
  };
  using Lines = std::vector<std::array<std::uint32_t, 2>>;
  CHECK(mesh_of(0).points.size() == 6);
  CHECK(lines(mesh_of(1)) == Lines{{0, 1}, {2, 3}, {4, 5}});
  CHECK(lines(mesh_of(2)) == Lines{{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}});
  CHECK(lines(mesh_of(3)) == Lines{{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}});
  CHECK(triangles(mesh_of(4)) == Triangles{{0, 1, 2}, {3, 4, 5}});
  CHECK(triangles(mesh_of(5)) == Triangles{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 5, 4}});
  CHECK(triangles(mesh_of(6)) == Triangles{{1, 2, 0}, {2, 3, 0}, {3, 4, 0}, {4, 5, 0}});
}

TEST_CASE("indices of every size give the same faces") {
  const auto load_with = [](auto sample, int component_type) {
    using T = decltype(sample);
    GltfBuilder b;
    json& primitive = b.triangle();
    primitive["indices"] = b.accessor(b.view(std::vector<T>{2, 0, 1}), component_type, "SCALAR", 3);
    return face_positions(loaded(b).meshes[0], 0);
  };
  const std::array<std::uint32_t, 3> expected{2, 0, 1};
  CHECK(load_with(std::uint8_t(), 5121) == expected);
  CHECK(load_with(std::uint16_t(), 5123) == expected);
  CHECK(load_with(std::uint32_t(), 5125) == expected);
}

TEST_CASE("normalised integers are c / max, at least -1, and plain ones are themselves") {
  GltfBuilder b;
  b.document["extensionsUsed"] = {"KHR_mesh_quantization"};
  b.document["extensionsRequired"] = {"KHR_mesh_quantization"};
  const std::size_t positions =
      b.accessor(b.view(std::vector<std::int8_t>{-128, 127, -127, 0, 1, 0, 0, 2, 0, 0, 5, 0}, 4),
                 5120, "VEC3", 3, {{"normalized", true}});
  json& primitive = b.primitive({{"attributes", {{"POSITION", positions}}}});
  primitive["attributes"]["COLOR_0"] =
      b.accessor(b.view(std::vector<std::uint16_t>{65535, 0, 13107, 0, 1, 2, 3, 0, 4, 5, 6, 0}, 8),
                 5123, "VEC3", 3, {{"normalized", true}});
  primitive["attributes"]["TEXCOORD_0"] =
      b.accessor(b.view(std::vector<std::int16_t>{-32768, 32767, 7, 8, 9, 10}), 5122, "VEC2", 3);
  const Mesh mesh = loaded(b).meshes[0];
  CHECK(mesh.positions[0] == Point<Object>(-1, 1, -1));
  CHECK(mesh.positions[1] == Point<Object>(float(1 / 127.0), 0, 0));
  CHECK(mesh.colors[0] == Rgba{1, 0, float(13107 / 65535.0), 1});
  CHECK(mesh.texcoords[0] == TexCoord{-32768, 32767});
}

TEST_CASE("interleaved attributes are read at their stride") {
  GltfBuilder b;
  const std::size_t view =
      b.view(std::vector<float>{0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1}, 24);
  const std::size_t positions = b.accessor(view, 5126, "VEC3", 3);
  const std::size_t normals = b.accessor(view, 5126, "VEC3", 3, {{"byteOffset", 12}});
  b.primitive({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}});
  const Mesh mesh = loaded(b).meshes[0];
  CHECK(mesh.positions[2] == Point<Object>(0, 1, 0));
  CHECK(mesh.normals[2] == Normal<Object>(0, 0, 1));
  CHECK(mesh.corners[1] == Corner{1, 1, kNone, kNone});
}

TEST_CASE("a sparse accessor replaces elements of its base, or of zeros where it has none") {
  for (const bool with_base : {true, false}) {
    GltfBuilder b;
    const std::size_t base = b.view(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0});
    const std::size_t indices = b.view(std::vector<std::uint16_t>{1, 2});
    const std::size_t values = b.view(std::vector<float>{7, 8, 9, 4, 5, 6});
    const std::size_t positions =
        b.accessor(base, 5126, "VEC3", 3,
                   {{"sparse",
                     {{"count", 2},
                      {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                      {"values", {{"bufferView", values}}}}}});
    if (!with_base) b.document["accessors"][positions].erase("bufferView");
    b.primitive({{"attributes", {{"POSITION", positions}}}});
    const Mesh mesh = loaded(b).meshes[0];
    CHECK(mesh.positions[0] == Point<Object>(0, 0, 0));
    CHECK(mesh.positions[1] == Point<Object>(7, 8, 9));
    CHECK(mesh.positions[2] == Point<Object>(4, 5, 6));
  }
}

TEST_CASE("indices without data are zeros, and sparse indices are legal") {
  GltfBuilder b;
  json& primitive = b.triangle();
  const std::size_t at = b.view(std::vector<std::uint8_t>{1, 2});
  const std::size_t values = b.view(std::vector<std::uint16_t>{1, 2});
  b.document["accessors"].push_back({{"componentType", 5123},
                                     {"count", 3},
                                     {"type", "SCALAR"},
                                     {"sparse",
                                      {{"count", 2},
                                       {"indices", {{"bufferView", at}, {"componentType", 5121}}},
                                       {"values", {{"bufferView", values}}}}}});
  primitive["indices"] = 1;
  CHECK(face_positions(loaded(b).meshes[0], 0) == std::array<std::uint32_t, 3>{0, 1, 2});
}

TEST_CASE(
    "node matrices are composed in double, from matrices and from translation, rotation and "
    "scale") {
  GltfBuilder b;
  b.triangle();
  // A quarter turn about z as an unnormalized quaternion, with a negative scale and a zero scale.
  b.document["nodes"] = {
      {{"children", {1}},
       {"translation", {0.1, 1e10, 3}},
       {"rotation", {0, 0, 2, 2}},
       {"scale", {-2, 3, 0}}},
      {{"mesh", 0}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0.25, 5, 1}}}};
  const Scene scene = loaded(b);
  REQUIRE(scene.nodes.size() == 2);
  CHECK(scene.nodes[1].parent == 0);
  const auto& m = scene.nodes[1].world_from_node;
  CHECK(m.at(0, 0) == 0);
  CHECK(m.at(1, 0) == -2);
  CHECK(m.at(0, 1) == -3);
  CHECK(m.at(2, 2) == 0);
  CHECK(m.at(0, 3) == 0.1 - 0.75);
  CHECK(m.at(1, 3) == 1e10 - 2);
  CHECK(m.at(2, 3) == 3);
  CHECK(scene.instances[0].node == 1);
}

TEST_CASE("a default material is listed only where a drawn primitive names none") {
  const auto names = [](const GltfBuilder& b) {
    std::vector<std::string> all;
    for (const Material& material : loaded(b).materials) all.push_back(material.name);
    return all;
  };
  GltfBuilder b;
  b.triangle()["material"] = 1;
  b.document["materials"] = {{{"name", "a"}}, {{"name", "b"}}};
  CHECK(names(b) == std::vector<std::string>{"a", "b"});
  b.triangle();
  CHECK(names(b) == std::vector<std::string>{"a", "b", "default"});
  CHECK(loaded(b).meshes[1].material == 2);
  b.document["scenes"] = {{{"nodes", {0}}}};
  CHECK(names(b) == std::vector<std::string>{"a", "b"});
}

TEST_CASE("the default scene is drawn, else the first, else all root nodes") {
  GltfBuilder b;
  b.triangle();
  b.document["nodes"] = {{{"mesh", 0}, {"name", "a"}}, {{"mesh", 0}, {"name", "b"}}};
  const auto drawn = [&] {
    std::string names;
    const Scene scene = loaded(b);
    for (const Instance& i : scene.instances) names += scene.nodes[i.node].name;
    return names;
  };
  CHECK(drawn() == "ab");
  b.document["scenes"] = {{{"nodes", {1}}}, {{"nodes", {0}}}};
  CHECK(drawn() == "b");
  b.document["scene"] = 1;
  CHECK(drawn() == "a");
}

TEST_CASE("cameras keep their numbers, and a scaled camera node is made rigid") {
  GltfBuilder b;
  b.triangle();
  b.document["cameras"] = {
      {{"type", "perspective"},
       {"name", "near"},
       {"perspective", {{"yfov", 0.7}, {"znear", 0.01}, {"zfar", 100}}}},
      {{"type", "perspective"}, {"perspective", {{"yfov", 1.1}, {"znear", 1}}}},
      {{"type", "orthographic"},
       {"orthographic", {{"xmag", 9}, {"ymag", 2.5}, {"znear", 0}, {"zfar", 10}}}}};
  b.document["nodes"].push_back({{"camera", 0}, {"translation", {1, 2, 3}}, {"scale", {2, 2, 2}}});
  b.document["nodes"].push_back({{"camera", 1}});
  b.document["nodes"].push_back({{"camera", 2}, {"name", "side"}});
  const Scene scene = loaded(b);
  REQUIRE(scene.cameras.size() == 3);
  CHECK(scene.cameras[0].name == "near");
  CHECK(scene.cameras[2].name == "side");
  const auto first = std::get<PerspectiveLens>(scene.cameras[0].lens);
  CHECK(first.fovy_radians == 0.7);
  CHECK(first.near == 0.01);
  CHECK(first.far == 100);
  CHECK_FALSE(std::get<PerspectiveLens>(scene.cameras[1].lens).far);
  CHECK(std::get<OrthographicLens>(scene.cameras[2].lens).half_height == 2.5);
  CHECK(scene.cameras[0].world_from_eye.at(0, 0) == 1);
  CHECK(scene.cameras[0].world_from_eye.at(2, 3) == 3);
}

TEST_CASE("lights stand where their node stands and shine along its -z axis") {
  GltfBuilder b;
  b.triangle();
  b.document["extensionsUsed"] = {"KHR_lights_punctual"};
  b.document["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "directional"}, {"intensity", 3}},
      {{"type", "point"}, {"color", {1, 0.5, 0}}, {"range", 7}},
      {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.2}}}}};
  for (int light = 0; light < 3; ++light) {
    b.document["nodes"].push_back({{"translation", {light, 1, 2}},
                                   {"scale", {1, 1, -3}},
                                   {"extensions", {{"KHR_lights_punctual", {{"light", light}}}}}});
  }
  const Scene scene = loaded(b);
  REQUIRE(scene.lights.size() == 3);
  CHECK(scene.lights[0].direction == Vector<World, double>(0, 0, 1));
  CHECK(scene.lights[0].intensity == 3);
  CHECK(scene.lights[1].position == Point<World, double>(1, 1, 2));
  CHECK(scene.lights[1].color == std::array<float, 3>{1, 0.5f, 0});
  CHECK(scene.lights[1].range == 7);
  CHECK(scene.lights[2].kind == LightKind::kSpot);
  CHECK(scene.lights[2].outer_cone_radians == 0.2);
}

TEST_CASE("metallic-roughness materials become the Blinn-Phong ones that load.h describes") {
  GltfBuilder b;
  b.triangle()["material"] = 0;
  b.document["extensionsUsed"] = {"KHR_materials_unlit"};
  b.document["materials"] = {
      {{"name", "gold"},
       {"alphaMode", "MASK"},
       {"alphaCutoff", 0.25},
       {"doubleSided", true},
       {"pbrMetallicRoughness",
        {{"baseColorFactor", {1, 0.5, 0.25, 0.75}},
         {"metallicFactor", 0.5},
         {"roughnessFactor", 0.5}}}},
      {{"extensions", {{"KHR_materials_unlit", json::object()}}}, {"alphaMode", "BLEND"}}};
  const Scene scene = loaded(b);
  const Material& gold = scene.materials[0];
  CHECK(gold.base_color == Rgba{1, 0.5f, 0.25f, 0.75f});
  CHECK(gold.alpha_mode == AlphaMode::kMask);
  CHECK(gold.alpha_cutoff == 0.25f);
  CHECK(gold.double_sided);
  // The expected values are (0.2 / 2 + 1 / 2) / 4 and 2 / 0.5^4 - 2.
  CHECK(gold.specular[0] == float(0.6 * 0.25));
  CHECK(gold.shininess == 30);
  CHECK(scene.materials[1].unlit);
  CHECK(scene.materials[1].alpha_mode == AlphaMode::kBlend);
}

TEST_CASE("the base colour texture brings its image, its sampler and the coordinates it asks for") {
  const Scene scene = loaded(textured_triangle({{"index", 0}, {"texCoord", 1}}));
  REQUIRE(scene.images.size() == 1);
  CHECK(scene.images[0].at(0, 0) == Rgba8{10, 20, 30, 40});
  REQUIRE(scene.materials[0].texture);
  const Sampler expected{Wrap::kClampToEdge, Wrap::kMirroredRepeat, Filter::kNearest,
                         Filter::kLinear, MipFilter::kNearest};
  CHECK(scene.textures[*scene.materials[0].texture].sampler == expected);
  CHECK(scene.meshes[0].texcoords[1] == TexCoord{0.5f, 0});
}

TEST_CASE("KHR_texture_transform is baked into the coordinates, its own set included") {
  // A quarter turn counter-clockwise as seen in the image: (u, v) becomes (v, -u), after the scale
  // and before the offset.
  const json transform = {
      {"offset", {10, 20}}, {"scale", {2, 4}}, {"rotation", kHalfPi}, {"texCoord", 0}};
  const Scene scene = loaded(textured_triangle(
      {{"index", 0}, {"texCoord", 1}, {"extensions", {{"KHR_texture_transform", transform}}}}));
  const std::vector<TexCoord>& uv = scene.meshes[0].texcoords;
  CHECK(uv[0] == TexCoord{10, 20});
  CHECK(uv[1] == TexCoord{10, 18});
  CHECK(uv[2] == TexCoord{14, 20});
}

TEST_CASE(
    "a missing set of texture coordinates and an image in an unsupported format are warnings") {
  const Scene scene = loaded(textured_triangle({{"index", 0}, {"texCoord", 5}}));
  REQUIRE(scene.warnings.size() == 2);  // and the texture coordinate sets that exist are not used
  CHECK(mentions(scene.warnings[1], "has a texture but no TEXCOORD_5"));
  CHECK(scene.meshes[0].texcoords.empty());
  GltfBuilder b = textured_triangle({{"index", 0}});
  b.document["textures"][0].erase("source");
  const Scene without = loaded(b);
  CHECK_FALSE(without.materials[0].texture);
  REQUIRE(without.warnings.size() == 2);
  CHECK(mentions(without.warnings[1], "texture 0: has no image in a supported format"));
}

TEST_CASE("normals are made unit length, and those without direction are left out and counted") {
  GltfBuilder b;
  json& primitive = b.triangle();
  primitive["attributes"]["NORMAL"] = b.floats({0, 0, 2, 0, 0, 0, 0.6f, 0.8f, 0}, "VEC3", 3);
  const Scene scene = loaded(b);
  const Mesh& mesh = scene.meshes[0];
  CHECK(mesh.normals[0] == Normal<Object>(0, 0, 1));
  CHECK(mesh.normals[2] ==
        Normal<Object>(0.6f, 0.8f, 0));  // a unit vector up to rounding is kept bit by bit
  CHECK(mesh.corners[0].normal == 0);
  CHECK(mesh.corners[1].normal == kNone);
  REQUIRE(scene.warnings.size() == 1);
  CHECK(mentions(scene.warnings[0], "normals of length zero were left out (1)"));
}

TEST_CASE("morph targets stand at the weights of the node, else of the mesh") {
  GltfBuilder b;
  json& primitive = b.triangle();
  primitive["attributes"]["NORMAL"] = b.floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 3);
  const std::size_t up = b.floats({0, 0, 1, 0, 0, 2, 0, 0, 3}, "VEC3", 3);
  const std::size_t turned = b.floats({0, 1, -1, 0, 1, -1, 0, 1, -1}, "VEC3", 3);
  primitive["targets"] = {{{"POSITION", up}, {"NORMAL", turned}}, {{"POSITION", turned}}};
  b.document["meshes"][0]["weights"] = {1, 0};
  b.document["nodes"].push_back({{"mesh", 0}, {"weights", {0, 0.5}}});
  b.document["nodes"].push_back({{"mesh", 0}});
  const Scene scene = loaded(b);
  REQUIRE(scene.meshes.size() == 2);
  CHECK(scene.meshes[0].positions[2] == Point<Object>(0, 1, 3));
  CHECK(scene.meshes[0].normals[0] == Normal<Object>(0, 1, 0));
  CHECK(scene.meshes[1].positions[0] == Point<Object>(0, 0.5f, -0.5f));
  CHECK(scene.instances[2].mesh == 0);
}

TEST_CASE("a skinned mesh stands where its joints put it, whatever its node says") {
  GltfBuilder b;
  json& primitive = b.triangle();
  primitive["attributes"]["JOINTS_0"] = b.accessor(
      b.view(std::vector<std::uint8_t>{0, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}), 5121, "VEC4", 3);
  primitive["attributes"]["WEIGHTS_0"] =
      b.floats({1, 0, 0, 0, 1, 0, 0, 0, .5f, .5f, 0, 0}, "VEC4", 4);
  primitive["attributes"]["NORMAL"] = b.floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 3);
  std::vector<float> inverse_bind(32, 0);
  for (const std::size_t i : {0u, 5u, 10u, 15u, 16u, 21u, 26u, 31u}) inverse_bind[i] = 1;
  inverse_bind[12] = -1;  // joint 0 was bound at x = 1
  const std::size_t matrices = b.floats(inverse_bind, "MAT4", 16);
  b.document["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", matrices}}};
  b.document["nodes"] = {
      {{"mesh", 0}, {"skin", 0}, {"translation", {100, 100, 100}}},
      {{"translation", {1, 0, 4}}},
      {{"translation", {0, 0, 8}}, {"rotation", {0, 1, 0, 0}}}};  // half a turn about y
  const Scene scene = loaded(b);
  const Mesh& mesh = scene.meshes[0];
  CHECK(mesh.positions[0] == Point<Object>(0, 0, 4));
  CHECK(mesh.positions[1] == Point<Object>(-1, 0, 8));
  CHECK(mesh.positions[2] == Point<Object>(0, 1, 6));
  CHECK(mesh.normals[1] == Normal<Object>(0, 0, -1));
  CHECK(scene.nodes[scene.instances[0].node].world_from_node == Transform<World, Object>());
}

TEST_CASE("an unsupported extension is an error where required and a warning where used") {
  GltfBuilder b;
  b.triangle();
  b.document["extensionsUsed"] = {"KHR_draco_mesh_compression"};
  CHECK(loaded(b).warnings.size() == 1);
  b.document["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  CHECK(mentions(error_of(b.load()), "KHR_draco_mesh_compression"));
}

TEST_CASE("a Draco primitive is drawn from its fallback accessors, and is an error without them") {
  GltfBuilder b;
  json& primitive = b.triangle();
  b.document["extensionsUsed"] = {"KHR_draco_mesh_compression"};
  primitive["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0}};
  CHECK(loaded(b).meshes.size() == 1);
  b.document["accessors"][0].erase("bufferView");
  CHECK(mentions(error_of(b.load()),
                 "mesh 0, primitive 0: is compressed with KHR_draco_mesh_compression"));
}
