// The OpenGL renderer of the benchmark draws the same as the engines, and its comparison detects
// where it does not.
#include <tests/support/catch.h>
#include <tests/support/mesa_leaks.h>
#include <tests/support/skip.h>

#include <functional>
#include <memory>
#include <string>

#include <glassbox/mesh/builtin/images.h>
#include <glassbox/mesh/builtin/placement.h>
#include <glassbox/mesh/builtin/shapes.h>
#include <glassbox/mesh/builtin/sphere.h>

#include <study/bench/glassbox_peer.h>
#include <study/bench/mesa/limits.h>
#include <study/bench/mesa/renderer.h>
#include "study/scenes/scenes.h"

namespace glassbox::study {
namespace {

constexpr int kWide = 320, kHigh = 180;

Mesh pane(std::uint32_t material, double repeat) {
  Mesh mesh;
  mesh.material = material;
  add_rectangle(mesh, {-1.2, -0.8, 0}, {2.4, 0, 0}, {0, 1.6, 0}, repeat, repeat);
  return mesh;
}

Mesh ball(std::uint32_t material) {
  Mesh mesh = make_sphere(16).meshes.front();
  mesh.material = material;
  return mesh;
}

void add_light(Scene& scene, LightKind kind, const Point<World, double>& position) {
  Light light;
  light.kind = kind;
  light.position = position;
  light.direction = unit({-position.x, -position.y, -position.z});
  light.intensity = 30;
  light.color = {1, 0.8f, 0.6f};
  light.range = 12;
  scene.lights.push_back(light);
}

// A scene with all properties that materials and lights can have.
Scene make_everything() {
  Scene scene;
  const std::uint32_t checks =
      add_texture(scene, make_checks(8, 16, {232, 228, 216}, {36, 40, 52}));
  const auto material = [&](const Rgba& color) -> Material& {
    return scene.materials[add_material(scene, "m", color)];
  };
  material({1, 1, 1, 1}).texture = checks;  // 0: tilted, so that levels are interpolated
  add_object(scene, pane(0, 3), placement_transform({-1.6, 0.9, -1}, 50));
  Material& shiny = material({0.2f, 0.5f, 0.3f, 1});  // 1
  shiny.specular = {0.5f, 0.5f, 0.4f};
  shiny.shininess = 24;
  add_object(scene, ball(1),
             placement_transform({1.4, 0.9, 0}, 20, {0.8, 0.5, 0.6}));  // scaled unevenly
  Material& glowing = material({0.1f, 0.1f, 0.4f, 1});                  // 2
  glowing.emission = {0.3f, 0.1f, 0};
  glowing.emission_texture = checks;
  glowing.double_sided = true;
  add_object(scene, pane(2, 1), placement_transform({1.3, -0.9, -0.5}, 160));  // shows its back
  Material& leaves = material({1, 1, 1, 1});                                   // 3
  Image<Rgba8> cut = make_checks(4, 32, {90, 160, 60, 255}, {90, 160, 60, 0});
  leaves.texture = add_texture(scene, std::move(cut));
  leaves.alpha_mode = AlphaMode::kMask;
  add_object(scene, pane(3, 1), placement_transform({-1.4, -0.9, -0.3}));
  Material& glass = material({0.9f, 0.3f, 0.2f, 0.4f});  // 4
  glass.alpha_mode = AlphaMode::kBlend;
  add_object(scene, pane(4, 1), placement_transform({0.1, 0, 0.6}));
  add_object(scene, pane(4, 1), placement_transform({-0.3, 0.2, 0.9}));
  add_object(scene, ball(1), placement_transform({0, -0.2, -1}, 0, {-0.5, 0.5, 0.5}));  // mirrored
  add_directional(scene, "sun", {-1, -1, -2}, 1.5);
  add_light(scene, LightKind::kPoint, {1, 2, 3});
  add_light(scene, LightKind::kSpot, {-2, 1, 4});
  return scene;
}

BenchScene bench_of(Scene scene) {
  Camera camera;
  camera.lens = PerspectiveLens{0.8, 0.5, std::nullopt};
  camera.world_from_eye.at(2, 3) = 5;
  BenchScene bench =
      make_bench_scene("everything", std::move(scene), make_view(camera, kWide, kHigh).value());
  return bench;
}

std::string describe_match(const PictureMatch& found) {
  std::string text =
      std::to_string(found.at_edges()) + " of " + std::to_string(found.allowed_at_edges()) +
      " at edges, " + std::to_string(found.colored_away_from_edges) + " elsewhere by up to " +
      std::to_string(found.largest_away_from_edges) + ", covered " + std::to_string(found.covered) +
      " " + std::to_string(found.peer_covered) + "; by 1/255:";
  for (std::size_t by = 1; by < 256; ++by) {
    if (found.differences[by] > 0)
      text += " " + std::to_string(by) + ":" + std::to_string(found.differences[by]);
  }
  return text;
}

bool mesa_is_missing() {
  return !OsMesa::open();
}

TEST_CASE("the peer draws every kind of material and light as the engines do") {
  if (mesa_is_missing()) SKIP_TEST("no libOSMesa.so.8 (Debian: libosmesa6)");
  const BenchScene bench = bench_of(make_everything());
  REQUIRE_FALSE(peer_cannot_draw(bench));
  const auto mesa = MesaRenderer::make(bench);
  REQUIRE(mesa);
  const PictureMatch found = match(GlassboxPeer(bench).picture(), (*mesa)->picture());
  INFO(describe_match(found));
  CHECK(found.same());
  CHECK(found.covered > 10000);
}

TEST_CASE("a fault planted in the scene is seen in the comparison with the peer") {
  if (mesa_is_missing()) SKIP_TEST("no libOSMesa.so.8 (Debian: libosmesa6)");
  const BenchScene bench = bench_of(make_everything());
  const auto mesa = MesaRenderer::make(bench);
  REQUIRE(mesa);
  const Picture theirs = (*mesa)->picture();
  const auto differs = [&](const char* fault, const std::function<void(Scene&)>& plant) {
    INFO(fault);
    Scene scene = make_everything();
    plant(scene);
    const BenchScene planted = bench_of(std::move(scene));
    const PictureMatch found = match(GlassboxPeer(planted).picture(), theirs);
    INFO(describe_match(found));
    CHECK_FALSE(found.same());
  };
  differs("a light from the other side", [](Scene& s) { s.lights[0].direction.x *= -1; });
  differs("a light's range", [](Scene& s) { s.lights[1].range = 6; });
  differs("a cone", [](Scene& s) { s.lights[2].outer_cone_radians = 0.3; });
  differs("a wrap", [](Scene& s) { s.textures[0].sampler.wrap_u = Wrap::kMirroredRepeat; });
  differs("no levels", [](Scene& s) { s.textures[0].sampler.mip = MipFilter::kNone; });
  differs("levels not mixed", [](Scene& s) { s.textures[0].sampler.mip = MipFilter::kNearest; });
  differs("a cutoff", [](Scene& s) { s.materials[3].alpha_cutoff = 0.9f; });
  differs("an exponent", [](Scene& s) { s.materials[1].shininess = 20; });
  differs("an emission", [](Scene& s) { s.materials[2].emission = {}; });
  differs("one side", [](Scene& s) { s.materials[2].double_sided = false; });
  differs("no blending", [](Scene& s) { s.materials[4].alpha_mode = AlphaMode::kOpaque; });
  differs("an alpha", [](Scene& s) { s.materials[4].base_color.a = 0.42f; });
}

TEST_CASE("what the peer would draw otherwise is named") {
  BenchScene bench = bench_of(make_everything());
  bench.settings.samples = 8;
  CHECK(peer_cannot_draw(bench)->find("samples") != std::string::npos);
  bench.settings.samples = 1;
  bench.scene.meshes[0].points.push_back({0, 0, 0, kNone});
  CHECK(peer_cannot_draw(bench)->find("points") != std::string::npos);
  bench.scene.meshes[0].points.clear();
  bench.scene.textures[0].sampler.minify = Filter::kNearest;
  CHECK(peer_cannot_draw(bench)->find("filter") != std::string::npos);
}

}  // namespace
}  // namespace glassbox::study
