#include "study/extremes/kit/screen_scene.h"

#include <algorithm>

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
    // Depths 0 to 1 lie between the planes at 0 and 1.
    const auto place = [&](const ScreenVertex& v) {
      return Point<Object>(v.position.x - half, half - v.position.y, -v.position.z);
    };
    add_triangle(mesh, {place(t[0]), place(t[1]), place(t[2])});
  }
  Camera camera;
  camera.lens = OrthographicLens{side / 2.0, 0, 1};
  return {scene_of(std::move(mesh), material), make_view(camera, side, side).value()};
}

Material unlit_material() {
  Material material;
  material.double_sided = true;
  material.unlit = true;
  return material;
}

TrianglesDrawn triangles_drawn(const std::vector<ScreenTriangle>& triangles, int side) {
  TrianglesDrawn drawn{Image<int>(side, side), Image<int>(side, side)};
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    pipeline_covers(triangles[i], {0, 0, side, side}, [&](int x, int y) {
      if (drawn.times.at(x, y)++ == 0) drawn.first.at(x, y) = int(i) + 1;
    });
  }
  return drawn;
}

namespace {

Image<int> integers(const Image<std::uint32_t>& plane) {
  Image<int> same(plane.width, plane.height);
  std::ranges::transform(plane.pixels, same.pixels.begin(),
                         [](std::uint32_t value) { return int(value); });
  return same;
}

}  // namespace

TrianglesDrawn drawn_by_tile_engine(const std::vector<ScreenTriangle>& triangles, int side,
                                    const TileOptions& options) {
  Material material = unlit_material();
  const ScreenScene opaque = screen_scene(triangles, side, material);
  RenderSettings ids;
  ids.want_id = true;
  material.base_color.a = 0.5f;
  material.alpha_mode = AlphaMode::kBlend;
  const ScreenScene blended = screen_scene(triangles, side, material);
  RenderSettings overdraw;
  overdraw.show = Show::kOverdraw;
  return {integers(render_tiled(opaque.scene, opaque.view, ids, options).buffers.id),
          integers(render_tiled(blended.scene, blended.view, overdraw, options).buffers.writes)};
}

}  // namespace glassbox::study
