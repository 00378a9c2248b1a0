// The mip levels of textures that are not visible are not made.
#include <glassbox/render/renderer.h>

#include "tests/render/plan/plan_checks.h"

namespace glassbox {
namespace {

using namespace test;

// A quad at depth z that covers the whole picture, with its own texture.
void add_textured_wall(Scene& scene, float z, std::uint32_t texture) {
  Mesh mesh;
  mesh.positions = {{-99, -99, z}, {99, -99, z}, {99, 99, z}, {-99, 99, z}};
  mesh.texcoords = {{0, 0}, {9, 0}, {9, 9}, {0, 9}};
  mesh.faces = {{0, 4}};
  for (std::uint32_t i = 0; i < 4; ++i) mesh.corners.push_back({i, kNone, i, kNone});
  mesh.material = texture;
  scene.meshes.push_back(mesh);
  Material material;
  material.texture = texture;
  scene.materials.push_back(material);
  scene.images.push_back(Image<Rgba8>(16, 8, {std::uint8_t(90 * texture), 200, 40, 255}));
  scene.textures.push_back({texture, Sampler{}});
  add_instance_at(scene, texture, {0, 0, 0});
}

}  // namespace

TEST_CASE("the levels of a texture are made when its first pixel asks for them") {
  Scene scene;
  add_textured_wall(scene, -3, 0);  // hides
  add_textured_wall(scene, -9, 1);  // this one
  add_textured_wall(scene, 99, 2);  // behind the camera
  const View view = planned_view();
  RenderSettings settings;
  Framebuffer target;
  Statistics statistics;
  for (const EngineKind kind : {EngineKind::kStaged, EngineKind::kTile}) {
    INFO(name_of(kind));
    const PreparedScene prepared = prepare_scene(scene, settings.transfer);
    const EyePicture eye{view, settings, target, target.color, statistics};
    make_engine(kind)->draw({scene, prepared, {&eye, 1}});
    CHECK(prepared.textures[0]->made());
    CHECK_FALSE(prepared.textures[1]->made());
    CHECK_FALSE(prepared.textures[2]->made());
    CHECK(prepared.textures[0]->get().last_level() == 4);
  }
}

TEST_CASE("what a hidden draw would ask for its alpha is not made either") {
  const View view = planned_view();
  RenderSettings settings;
  Framebuffer target;
  Statistics statistics;
  for (const AlphaMode mode : {AlphaMode::kMask, AlphaMode::kBlend}) {
    for (const int samples : {1, 4}) {
      settings.samples = samples;
      Scene scene;
      add_textured_wall(scene, -3, 0);  // hides
      add_textured_wall(scene, -9, 1);
      add_textured_wall(scene, -2, 2);  // in front of both
      scene.materials[1].alpha_mode = scene.materials[2].alpha_mode = mode;
      scene.materials[2].base_color.a = 0.25f;  // with a mask it is discarded everywhere
      for (const EngineKind kind : {EngineKind::kStaged, EngineKind::kTile}) {
        INFO(name_of(kind) << ", alpha mode " << int(mode) << ", " << samples << " samples");
        const PreparedScene prepared = prepare_scene(scene, settings.transfer);
        const EyePicture eye{view, settings, target, target.color, statistics};
        make_engine(kind)->draw({scene, prepared, {&eye, 1}});
        CHECK(prepared.textures[0]->made());
        CHECK_FALSE(prepared.textures[1]->made());
        CHECK(prepared.textures[2]->made());
      }
    }
  }
}

}  // namespace glassbox
