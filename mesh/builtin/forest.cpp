#include <glassbox/mesh/builtin/forest.h>

#include <string>
#include <vector>

#include <glassbox/mesh/builtin/images.h>
#include <glassbox/mesh/builtin/placement.h>
#include <glassbox/mesh/builtin/shapes.h>

namespace glassbox {
namespace {

constexpr int kTrees = 150;

// The trunk is one unit high; each instance scales it.
Mesh make_trunk() {
  Mesh mesh;
  mesh.name = "trunk";
  add_tube(mesh, 0.018, 0.005, 0, 0.9, 8);
  return mesh;
}

Mesh make_crown() {
  Mesh mesh;
  mesh.name = "crown";
  add_cone(mesh, 0.16, 0.35, 0.66, 12);
  add_cone(mesh, 0.125, 0.52, 0.83, 12);
  add_cone(mesh, 0.085, 0.7, 1.0, 12);
  return mesh;
}

struct Spot {
  double x, z;
};

// Whether a tree may be placed at `spot`, which must not be too close to the trees in `taken`.
bool is_free(const Spot& spot, const std::vector<Spot>& taken) {
  for (const Spot& other : taken) {
    const double x = spot.x - other.x, z = spot.z - other.z;
    if (x * x + z * z < 1.2 * 1.2) return false;
  }
  return true;
}

// Chooses random places for trees on the part of the ground that a wide picture shows, |x| < 0.75
// times the distance. The trees are denser near the eye, where a tree covers more of the picture.
std::vector<Spot> choose_spots() {
  std::vector<Spot> spots;
  for (std::uint64_t i = 0; spots.size() < kTrees; ++i) {
    const double t = random_unit(1, i);
    const double distance = 4 + 86 * t * t;
    const double side = 2 * random_unit(2, i) - 1;
    const Spot spot = {side * 0.75 * distance, -distance};
    if (is_free(spot, spots)) spots.push_back(spot);
  }
  return spots;
}

}  // namespace

Scene make_forest() {
  Scene scene;
  scene.name = "forest";
  const std::uint32_t moss = add_material(scene, "ground", {1, 1, 1, 1});
  scene.materials[moss].texture = add_texture(scene, make_noise(256, {112, 118, 70}, 40, 11));
  const std::uint32_t bark = add_material(scene, "bark", {0.16f, 0.085f, 0.04f, 1});
  // A trunk is a tube with open ends, through which its inside may be visible.
  scene.materials[bark].double_sided = true;
  const std::uint32_t needles = add_material(scene, "needles", {0.03f, 0.16f, 0.05f, 1});

  Mesh ground;
  ground.name = "ground";
  ground.material = moss;
  add_rectangle(ground, {-128, 0, 64}, {256, 0, 0}, {0, 0, -192}, 64, 48);
  add_object(scene, std::move(ground));

  // A bright background, against which every trunk has a visible edge.
  Mesh sky;
  sky.name = "sky";
  sky.material = add_material(scene, "sky", {0.42f, 0.6f, 0.85f, 1});
  scene.materials[sky.material].unlit = true;
  add_rectangle(sky, {-256, -8, -128}, {512, 0, 0}, {0, 200, 0});
  add_object(scene, std::move(sky));

  const auto trunk = std::uint32_t(scene.meshes.size()), crown = trunk + 1;
  scene.meshes.push_back(make_trunk());
  scene.meshes[trunk].material = bark;
  scene.meshes.push_back(make_crown());
  scene.meshes[crown].material = needles;
  const std::vector<Spot> spots = choose_spots();
  for (std::size_t i = 0; i < spots.size(); ++i) {
    const double height = 4 + 3 * random_unit(3, i);
    const double girth = height * (0.4 + 0.3 * random_unit(4, i));
    const double turn_degrees = 360 * random_unit(5, i);
    const Transform<World, Object> stand =
        placement_transform({spots[i].x, 0, spots[i].z}, turn_degrees, {girth, height, girth});
    const std::string number = std::to_string(i);
    add_instance(scene, trunk, "trunk " + number, stand);
    add_instance(scene, crown, "crown " + number, stand);
  }

  add_perspective(scene, "path", 45, 0.25, look_at_pose({0, 1.7, 0}, {0, 2.3, -12}));
  add_directional(scene, "sun", {-0.55, -1, -0.6}, 2.8, {1, 0.95f, 0.85f});
  add_directional(scene, "sky", {0.4, -0.8, 0.3}, 0.5, {0.7f, 0.85f, 1});
  return scene;
}

}  // namespace glassbox
