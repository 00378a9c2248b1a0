#include <glassbox/mesh/builtin/cube.h>

#include <glassbox/mesh/builtin/placement.h>
#include <glassbox/mesh/builtin/shapes.h>

namespace glassbox {

Scene make_cube() {
  Scene scene;
  scene.name = "cube";
  Mesh mesh;
  mesh.name = "cube";
  // The sides that face +x, +y and +z are red, green and blue; the opposite sides have the
  // complementary colours.
  const std::array<std::uint32_t, 6> colors = {
      add_color(mesh, {0.05f, 0.7f, 0.7f, 1}),  add_color(mesh, {0.8f, 0.05f, 0.04f, 1}),
      add_color(mesh, {0.7f, 0.05f, 0.6f, 1}),  add_color(mesh, {0.08f, 0.6f, 0.06f, 1}),
      add_color(mesh, {0.8f, 0.65f, 0.03f, 1}), add_color(mesh, {0.05f, 0.12f, 0.8f, 1})};
  add_box(mesh, {-1, -1, -1}, {1, 1, 1}, colors);
  mesh.material = add_material(scene, "painted", {1, 1, 1, 1});
  add_object(scene, std::move(mesh));
  return scene;
}

}  // namespace glassbox
