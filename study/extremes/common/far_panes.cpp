#include "study/extremes/common/far_panes.h"

#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/view.h>

#include "study/extremes/common/drawn_coverage.h"
#include "study/extremes/common/screen_scene.h"

namespace glassbox::study {

namespace {

Mesh mesh_of_pane(float z, bool in_company) {
  Mesh mesh;
  const Point<Object> a{-1e5f, -1e5f, z}, b{1e5f, -1e5f, z}, c{1e5f, 1e5f, z}, d{-1e5f, 1e5f, z};
  add_triangle(mesh, {a, b, c});
  add_triangle(mesh, {a, c, d});
  // The added triangle extends from behind the eye to far away. It is far to the right of the
  // picture, by a hundred thousand times the picture's width.
  if (in_company) {
    add_triangle(mesh, {Point<Object>{5e5f, 0, z - 5e5f}, {6e5f, 0, z}, {5e5f, 1e5f, z + 5e5f}});
  }
  return mesh;
}

Scene scene_of_panes(const std::vector<FarPane>& panes, bool in_company) {
  Scene scene;
  for (const FarPane& pane : panes) {
    const auto number = std::uint32_t(scene.meshes.size());
    Material material = unlit_material();
    material.base_color = {pane.color[0], pane.color[1], pane.color[2], 1};
    scene.materials.push_back(material);
    Mesh mesh = mesh_of_pane(pane.z, in_company);
    mesh.material = number;
    scene.meshes.push_back(std::move(mesh));
    Node node;
    node.world_from_node = node.parent_from_node =
        translate<World, World>(Vector<World, double>{0, 0, -0.5 - pane.behind_near - 1e6 * 1e-5}) *
        scale<World, Object>(1, 1, pane.scale_z);
    scene.nodes.push_back(node);
    scene.instances.push_back({number, number});
  }
  return scene;
}

}  // namespace

PixelChanges compare_with_added_triangle(const TestedEngine& engine,
                                         const std::vector<FarPane>& panes) {
  Camera camera;
  camera.lens = OrthographicLens{2, 0.5, 20};
  const View view = make_view(camera, 8, 8).value();
  RenderSettings settings = plain_settings();
  settings.want_id = false;  // with triangle ids, several draws would never be drawn together
  const auto drawn = [&](bool in_company) {
    return engine.draw(scene_of_panes(panes, in_company), view, settings).buffers.color;
  };
  const auto alone = drawn(false), together = drawn(true);
  PixelChanges changes;
  for (std::size_t i = 0; i < alone.pixels.size(); ++i) {
    changes.changed += alone.pixels[i] != together.pixels[i];
    changes.shown += together.pixels[i] != settings.background;
  }
  return changes;
}

}  // namespace glassbox::study
