// The scenes of the stereo-culling experiment (D-10), and what disappears from a picture if
// triangles are left out.
#pragma once

#include <vector>

#include <glassbox/base/trig.h>
#include <glassbox/mesh/builtin/placement.h>
#include <glassbox/mesh/builtin/shapes.h>
#include <glassbox/render/tile/tile_engine.h>

#include "study/experiments/d10_methods.h"

namespace glassbox::study::d10 {

// ---- what is lost ----

// The scene with only the triangles that are kept; each draw has a mesh of its own.
inline Scene subset(const Eyes& eyes, const std::vector<DrawKeepFlags>& kept, bool left) {
  Scene scene = eyes.scene;
  scene.meshes.clear();
  scene.instances.clear();
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const Draw& draw = eyes.list.draws[i];
    const KeepFlags& mine = left || kept[i].right.empty() ? kept[i].left : kept[i].right;
    Mesh mesh = *draw.mesh;
    mesh.faces.clear();
    mesh.corners.clear();
    for (std::size_t t = 0; t < mine.size(); ++t) {
      if (!mine[t]) continue;
      mesh.faces.push_back({std::uint32_t(mesh.corners.size()), 3});
      for (const std::uint32_t corner : draw.triangulation->triangles[t].corners)
        mesh.corners.push_back(draw.mesh->corners[corner]);
    }
    if (mesh.faces.empty()) continue;
    scene.instances.push_back(
        {std::uint32_t(scene.meshes.size()), eyes.scene.instances[draw.instance].node});
    scene.meshes.push_back(std::move(mesh));
  }
  return scene;
}

inline RenderSettings distances_only() {
  RenderSettings settings;
  settings.mask = {false, false, false, false};
  settings.want_distance = settings.want_id = true;
  return settings;
}

inline Framebuffer draw(const Scene& scene, const View& view) {
  return render_tiled(scene, view, distances_only(), {.threads = 1}).buffers;
}

// The number of pixels per row and eye that are lost because their triangles are left out.
inline double lost_columns(const Eyes& eyes, const std::vector<DrawKeepFlags>& kept) {
  double lost = 0;
  for (const bool left : {true, false}) {
    const View& view = left ? eyes.left : eyes.right;
    const Image<float> all = draw(eyes.scene, view).distance,
                       drawn = draw(subset(eyes, kept, left), view).distance;
    for (std::size_t i = 0; i < all.pixels.size(); ++i) lost += all.pixels[i] != drawn.pixels[i];
  }
  return lost / (2 * kHeight);
}

// ---- scenes ----

inline constexpr double kWindow = 12;

inline View centre_view() {
  Camera camera;
  camera.lens = PerspectiveLens{0.785398163397448309616, 0.5, 200.0};
  return make_view(camera, kWidth, kHeight).value();
}

// Thin upright strips, a quarter of a pixel wide, beyond both sides of the picture, at `distance`.
inline Scene strips(double distance) {
  Scene scene;
  add_material(scene, "flat", {1, 1, 1, 1});
  scene.materials.front().unlit = true;
  const double height = distance * tan_half_degrees(45), pixel = 2 * height / kHeight;
  Mesh mesh;
  for (int i = -4 * 220; i < 4 * 220; ++i)
    add_rectangle(mesh, {i * pixel / 4, -2 * height, -distance}, {pixel / 4, 0, 0},
                  {0, 4 * height, 0});
  add_object(scene, std::move(mesh));
  return scene;
}

}  // namespace glassbox::study::d10
