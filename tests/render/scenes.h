// Small scenes for the tests of whole runs.
#pragma once

#include <tests/support/catch.h>

#include <array>
#include <string>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/mesh/bounding_box.h>
#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/framing.h>
#include <glassbox/pipeline/look_at.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/settings.h>

namespace glassbox::test {

inline Scene built_in(const std::string& name) {
  const auto scene = make_builtin(name);
  REQUIRE(scene);
  return *scene;
}

inline RenderSettings with_ids() {
  RenderSettings settings;
  settings.want_id = true;
  return settings;
}

inline Scene scene_of(Mesh mesh, Material material = {}) {
  Scene scene;
  scene.name = "test";
  scene.materials = {std::move(material)};
  scene.nodes = {Node{"root", kNone, {}, {}}};
  scene.instances = {Instance{0, 0}};
  scene.meshes = {std::move(mesh)};
  return scene;
}

inline void add_face(Mesh& mesh, const std::vector<std::uint32_t>& positions) {
  mesh.faces.push_back({std::uint32_t(mesh.corners.size()), std::uint32_t(positions.size())});
  for (const std::uint32_t position : positions) mesh.corners.push_back({position});
}

// A closed surface around the origin that every ray from there meets exactly once: a cube of side 2
// whose faces are grids of n x n quads, with vertices moved to random distances in [1, 1 +
// roughness] along their rays.
inline Mesh star_shaped_surface(int n, double roughness, Random& random) {
  Mesh mesh;
  std::vector<std::vector<std::vector<std::uint32_t>>> index(
      std::size_t(n + 1),
      std::vector<std::vector<std::uint32_t>>(
          std::size_t(n + 1), std::vector<std::uint32_t>(std::size_t(n + 1), kNone)));
  const auto vertex = [&](std::array<int, 3> at) {
    std::uint32_t& i = index[std::size_t(at[0])][std::size_t(at[1])][std::size_t(at[2])];
    if (i == kNone) {
      i = std::uint32_t(mesh.positions.size());
      const double r = 1 + roughness * random.unit();
      const auto coordinate = [&](int k) { return float(r * (2.0 * k / n - 1)); };
      mesh.positions.push_back({coordinate(at[0]), coordinate(at[1]), coordinate(at[2])});
    }
    return i;
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {0, n}) {
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          const auto corner = [&](int u, int v) {
            std::array<int, 3> at{};
            at[std::size_t(axis)] = side;
            at[std::size_t((axis + 1) % 3)] = i + u;
            at[std::size_t((axis + 2) % 3)] = j + v;
            return vertex(at);
          };
          if (side == n) {
            add_face(mesh, {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)});
          } else {
            add_face(mesh, {corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0)});
          }
        }
      }
    }
  }
  return mesh;
}

// The scene's first camera, or the automatic one.
inline Camera camera_for(const Scene& scene, double aspect) {
  return scene.cameras.empty() ? *framing_camera(bounds(scene), aspect) : scene.cameras.front();
}

// A camera at `eye` that looks along a random direction.
inline Camera random_gaze(const Point<World, double>& eye, const Lens& lens, Random& random) {
  for (;;) {
    const Point<World, double> target{eye.x + random.between(-1, 1), eye.y + random.between(-1, 1),
                                      eye.z + random.between(-1, 1)};
    const auto eye_from_world =
        look_at(eye, target, {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)});
    if (eye_from_world) return {"random", lens, inverse_rigid(*eye_from_world)};
  }
}

}  // namespace glassbox::test
