#include "study/extremes/common/screen_scene.h"

namespace glassbox::study {

void add_triangle(Mesh& mesh, const std::array<Point<Object>, 3>& corners) {
  mesh.faces.push_back({std::uint32_t(mesh.corners.size()), 3});
  for (const Point<Object>& corner : corners) {
    mesh.corners.push_back({.position = std::uint32_t(mesh.positions.size())});
    mesh.positions.push_back(corner);
  }
}

Scene scene_of(Mesh mesh, const Material& material) {
  Scene scene;
  scene.name = "study";
  scene.materials = {material};
  scene.nodes = {Node{"root", kNone, {}, {}}};
  scene.instances = {Instance{0, 0}};
  scene.meshes = {std::move(mesh)};
  return scene;
}

ScreenScene screen_scene(const std::vector<ScreenTriangle>& triangles, int side,
                         const Material& material) {
  const float half = float(side) / 2;
  Mesh mesh;
  for (const ScreenTriangle& t : triangles) {
    // The near and far planes are at 0 and 1, so vertices with depths from 0 to 1 are between them.
    const auto place = [&](const ScreenVertex& v) {
      return Point<Object>(v.position.x - half, half - v.position.y, -v.position.z);
    };
    add_triangle(mesh, {place(t[0]), place(t[1]), place(t[2])});
  }
  Camera camera;
  camera.lens = OrthographicLens{side / 2.0, 0, 1};
  return {scene_of(std::move(mesh), material), make_view(camera, side, side).value()};
}

Scene one_draw_per_triangle(const Scene& scene) {
  Scene split = scene;
  split.meshes.clear();
  split.instances.clear();
  const Mesh& whole = scene.meshes[0];
  for (const Face& face : whole.faces) {
    const auto corner = [&](std::uint32_t k) {
      return whole.positions[whole.corners[face.first + k].position];
    };
    split.instances.push_back({std::uint32_t(split.meshes.size()), 0});
    add_triangle(split.meshes.emplace_back(), {corner(0), corner(1), corner(2)});
  }
  return split;
}

Material unlit_material() {
  Material material;
  material.double_sided = true;
  material.unlit = true;
  return material;
}

}  // namespace glassbox::study
