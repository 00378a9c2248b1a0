// The emission of surfaces, read from glTF and written to it.
#include <array>

#include <glassbox/images/write.h>
#include <glassbox/mesh/gltf/write.h>

#include "tests/mesh/gltf_builder.h"
#include "tests/support/catch.h"

using namespace glassbox;
using namespace glassbox::test;

namespace {

using Emission = std::array<float, 3>;

Scene loaded(const GltfBuilder& builder) {
  auto scene = builder.load();
  INFO(error_of(scene));
  REQUIRE(scene);
  return std::move(*scene);
}

// A triangle with this material, one set of texture coordinates and two textures of one texel.
GltfBuilder with_material(const json& material) {
  GltfBuilder b;
  json& primitive = b.triangle();
  primitive["attributes"]["TEXCOORD_0"] = b.floats({0, 0, 1, 0, 0, 1}, "VEC2", 2);
  primitive["material"] = 0;
  const auto png = encode_png(Image<Rgba8>(1, 1, {10, 20, 30, 255}));
  REQUIRE(png);
  const std::size_t view = b.view(*png);
  b.document["images"] = {{{"bufferView", view}, {"mimeType", "image/png"}}};
  b.document["textures"] = {{{"source", 0}}, {{"source", 0}}};
  b.document["materials"] = json::array({material});
  return b;
}

json strength(double s) {
  return {{"KHR_materials_emissive_strength", {{"emissiveStrength", s}}}};
}

bool any_mentions(const Scene& scene, const std::string& part) {
  for (const std::string& warning : scene.warnings) {
    if (mentions(warning, part)) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("the emission of a material is its factor times its strength") {
  const Scene plain = loaded(with_material({{"emissiveFactor", {0.5, 0.25, 1}}}));
  CHECK(plain.materials[0].emission == Emission{0.5f, 0.25f, 1});
  CHECK_FALSE(plain.materials[0].emission_texture);
  CHECK(plain.warnings.empty());
  const Scene strong =
      loaded(with_material({{"emissiveFactor", {0.5, 0.25, 1}}, {"extensions", strength(8)}}));
  CHECK(strong.materials[0].emission == Emission{4, 2, 8});
  CHECK(strong.warnings.empty());
  const Scene blinding =
      loaded(with_material({{"emissiveFactor", {1, 0, 0}}, {"extensions", strength(1e300)}}));
  CHECK(blinding.materials[0].emission == Emission{1e18f, 0, 0});
  CHECK(mentions(error_of(with_material({{"emissiveFactor", {2, 0, 0}}}).load()),
                 "material 0, emissiveFactor[0]"));
}

TEST_CASE("an emissive texture is loaded, and one whose factor is zero or unlit is not asked for") {
  const json texture = {{"index", 1}};
  const Scene scene =
      loaded(with_material({{"emissiveFactor", {1, 1, 1}}, {"emissiveTexture", texture}}));
  REQUIRE(scene.materials[0].emission_texture);
  CHECK(scene.images[scene.textures[*scene.materials[0].emission_texture].image].at(0, 0) ==
        Rgba8{10, 20, 30, 255});
  CHECK(scene.warnings.empty());
  const Scene black = loaded(with_material({{"emissiveTexture", texture}}));
  CHECK_FALSE(emits_light(black.materials[0]));
  CHECK(black.images.empty());
  const Scene unlit = loaded(with_material({{"emissiveFactor", {1, 1, 1}},
                                            {"emissiveTexture", texture},
                                            {"extensions", {{"KHR_materials_unlit", {}}}}}));
  CHECK_FALSE(emits_light(unlit.materials[0]));
}

TEST_CASE("an emission that needs other coordinates than the base colour is left out and named") {
  const json base = {{"baseColorTexture", {{"index", 0}}}};
  const auto with = [&](const json& emissive) {
    return loaded(with_material({{"pbrMetallicRoughness", base},
                                 {"emissiveFactor", {1, 1, 1}},
                                 {"emissiveTexture", emissive}}));
  };
  const Scene same = with({{"index", 1}});
  CHECK(same.materials[0].emission_texture);
  CHECK(same.warnings.empty());
  const json moved = {{"index", 1},
                      {"extensions", {{"KHR_texture_transform", {{"scale", {2, 2}}}}}}};
  for (const json& other : {json{{"index", 1}, {"texCoord", 1}}, moved}) {
    const Scene scene = with(other);
    CHECK_FALSE(emits_light(scene.materials[0]));
    CHECK(scene.materials[0].texture);
    CHECK(any_mentions(scene, "material 0: its emission was left out"));
  }
}

TEST_CASE("what a material emits comes back from a written GLB, beyond 1 and bit by bit") {
  for (const Emission& emission : {Emission{0.1f, 0, 0.7f}, {12.3f, 1e-7f, 0.1f}}) {
    Scene scene =
        loaded(with_material({{"emissiveFactor", {1, 1, 1}}, {"emissiveTexture", {{"index", 1}}}}));
    scene.materials[0].emission = emission;
    const auto file = encode_glb(scene);
    REQUIRE(file);
    const auto back = load_gltf_memory(*file, "");
    INFO(error_of(back));
    REQUIRE(back);
    CHECK(back->materials[0].emission == emission);
    CHECK(back->materials[0].emission_texture == scene.materials[0].emission_texture);
    CHECK(back->warnings.empty());
  }
}
