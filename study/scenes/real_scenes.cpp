#include "study/scenes/real_scenes.h"

#include <algorithm>
#include <string>

#include <glassbox/mesh/builtin/cube.h>
#include <glassbox/mesh/builtin/images.h>
#include <glassbox/mesh/builtin/placement.h>
#include <glassbox/mesh/builtin/shapes.h>
#include <glassbox/mesh/builtin/sphere.h>

namespace glassbox::study {

namespace {

constexpr RealScene kScenes[] = {
    {"R1", "textures, a lamp and highlights, from inside", "room"},
    {"R2", "a textured floor to the horizon, with mip levels", "checker"},
    {"R3", "300 objects, many of them thin and far", "forest"},
    {"R4", "a smooth surface of small triangles", "teapot:64"},
    {"R5", "a textured model from a file", "meshes/gltf/Avocado/glTF/Avocado.gltf", true},
    {"R6", "R1 with 4 samples of a pixel", "room", false, 4},
    {"R7", "S2 with 4 samples of a pixel", "S2", false, 4},
    {"R8", "leaves cut out by alpha", "thicket"},
    {"R9", "32 blended layers of glass", ""},
    {"R10", "100,000 instances of a cube", ""},
    {"R11", "100 spheres behind a wall", ""},
    {"R12", "200 spheres, 10 of them in view", ""},
};

// ---- parts ----

Scene empty_scene(std::string_view name) {
  Scene scene;
  scene.name = name;
  add_perspective(scene, "front", 45, 0.5, look_at_pose({0, 0, 8}, {0, 0, 0}));
  add_directional(scene, "light", {-1, -1, -2}, 2.8);
  return scene;
}

float shade_of(std::uint64_t seed, std::uint64_t index) {
  return float(0.1 + 0.8 * random_unit(seed, index));
}

Rgba color_of(std::uint64_t index, float alpha) {
  return {shade_of(1, index), shade_of(2, index), shade_of(3, index), alpha};
}

// An upright rectangle, centred at the origin, facing +z.
Mesh make_pane(double width, double height, std::uint32_t material, double repeat = 1) {
  Mesh mesh;
  mesh.name = "pane";
  mesh.material = material;
  add_rectangle(mesh, {-width / 2, -height / 2, 0}, {width, 0, 0}, {0, height, 0}, repeat, repeat);
  return mesh;
}

Mesh only_mesh_of(Scene made, std::uint32_t material) {
  Mesh mesh = std::move(made.meshes.front());
  mesh.material = material;
  return mesh;
}

// ---- R9 to R12 ----

// Panes of glass one behind the other, in front of a wall; the file lists them in no particular
// order.
Scene make_glass() {
  Scene scene = empty_scene("glass");
  const std::uint32_t wall = add_material(scene, "wall", {1, 1, 1, 1});
  scene.materials[wall].texture =
      add_texture(scene, make_checks(8, 32, {232, 228, 216}, {36, 40, 52}));
  add_object(scene, make_pane(24, 16, wall, 2), placement_transform({0, 0, -6}));
  for (int i = 0; i < kGlassLayers; ++i) {
    const auto number = std::uint64_t(i);
    const std::uint32_t glass =
        add_material(scene, "glass " + std::to_string(i), color_of(number, 0.125f));
    scene.materials[glass].alpha_mode = AlphaMode::kBlend;
    const int layer = 5 * i % kGlassLayers, aside = i - kGlassLayers / 2;
    add_object(scene, make_pane(9, 5.5, glass),
               placement_transform({0.02 * aside, 0.01 * i, -4 + layer * 0.25}));
  }
  return scene;
}

Scene make_many() {
  Scene scene = empty_scene("many");
  const std::uint32_t material = add_material(scene, "matte", {0.8f, 0.6f, 0.4f, 1});
  scene.meshes.push_back(only_mesh_of(make_cube(), material));
  constexpr int kAcross = 50, kDown = 40, kDeep = kManyInstances / kAcross / kDown;
  static_assert(kAcross * kDown * kDeep == kManyInstances);
  for (int i = 0; i < kManyInstances; ++i) {
    const int x = i % kAcross, y = i / kAcross % kDown, z = i / kAcross / kDown;
    const double turn_degrees = 360 * random_unit(4, std::uint64_t(i));
    add_instance(scene, 0, "cube",
                 placement_transform(
                     {(x - (kAcross - 1) / 2.0) * 0.3, (y - (kDown - 1) / 2.0) * 0.3, -z * 0.5},
                     turn_degrees, {0.05, 0.05, 0.05}));
  }
  return scene;
}

Scene make_hidden() {
  Scene scene = empty_scene("hidden");
  add_object(scene, make_pane(24, 16, add_material(scene, "wall", {0.7f, 0.7f, 0.65f, 1})),
             placement_transform({0, 0, 2}));
  constexpr int kSide = 10;
  static_assert(kSide * kSide == kHiddenSpheres);
  scene.meshes.push_back(
      only_mesh_of(make_sphere(kSphereLevel), add_material(scene, "ball", {0.8f, 0.3f, 0.2f, 1})));
  for (int i = 0; i < kHiddenSpheres; ++i) {
    const int column = i % kSide, row = i / kSide;
    add_instance(
        scene, 1, "ball",
        placement_transform({(column - 4.5) * 0.9, (row - 4.5) * 0.6, 0}, 0, {0.3, 0.3, 0.3}));
  }
  return scene;
}

// Two rows of five objects are in front of the eye; all other objects are behind it or beside it.
Scene make_scattered() {
  Scene scene = empty_scene("scattered");
  scene.meshes.push_back(
      only_mesh_of(make_sphere(kSphereLevel), add_material(scene, "ball", {0.3f, 0.5f, 0.8f, 1})));
  for (int i = 0; i < kScattered; ++i) {
    const int column = i % 5 - 2, row = i / 5;
    if (i < kScatteredInView) {
      add_instance(scene, 0, "seen",
                   placement_transform({column * 1.2, row * 1.4 - 0.7, 0}, 0, {0.5, 0.5, 0.5}));
      continue;
    }
    const double aside = row % 3 == 0 ? 0 : row % 3 == 1 ? -60 : 60;
    const double behind = row % 3 == 0 ? 14 : 0;
    add_instance(scene, 0, "unseen",
                 placement_transform({aside + column * 1.2, row % 7 * 1.4 - 4, behind + row % 5}, 0,
                                     {0.5, 0.5, 0.5}));
  }
  return scene;
}

Result<Scene> make(std::string_view name) {
  if (name == "R9") return make_glass();
  if (name == "R10") return make_many();
  if (name == "R11") return make_hidden();
  if (name == "R12") return make_scattered();
  return fail(std::string(name), "is not a scene that can be made", "try R9 to R12");
}

}  // namespace

std::span<const RealScene> real_scenes() {
  return kScenes;
}

const RealScene* find_real_scene(std::string_view name) {
  const auto found = std::ranges::find_if(
      kScenes, [&](const RealScene& known) { return same_name(known.name, name); });
  return found == std::end(kScenes) ? nullptr : &*found;
}

Result<BenchScene> make_real_scene(std::string_view name, int width, int height) {
  const RealScene* known = find_real_scene(name);
  auto scene = make(known != nullptr ? known->name : name);
  if (!scene) return tl::unexpected(scene.error());
  const auto view = make_view(scene->cameras.front(), width, height);
  if (!view) return tl::unexpected(view.error());
  return make_bench_scene(std::string(known->name), std::move(*scene), *view);
}

}  // namespace glassbox::study
