#include <glassbox/mesh/builtin/depth_ladder.h>

#include <glassbox/base/trig.h>
#include <glassbox/mesh/builtin/placement.h>
#include <glassbox/mesh/builtin/shapes.h>

namespace glassbox {
namespace {

constexpr int kColumns = 5, kRows = 4;

// The squares of one colour from all rungs. Sizes are in units of the rung's distance from the eye,
// so that every rung covers the same area of the picture.
Mesh make_squares(const char* name, double half_side, double nearer_by) {
  Mesh mesh;
  mesh.name = name;
  for (int rung = 0; rung < kColumns * kRows; ++rung) {
    const double distance = double(1 << rung) * (1 - nearer_by);
    const int column = rung % kColumns, row = rung / kColumns;
    const double x = 0.2 * (column - 0.5 * (kColumns - 1));
    const double y = 0.2 * (0.5 * (kRows - 1) - row);
    const double side = 2 * half_side * distance;
    add_rectangle(mesh, {(x - half_side) * distance, (y - half_side) * distance, -distance},
                  {side, 0, 0}, {0, side, 0});
  }
  return mesh;
}

std::uint32_t add_unlit(Scene& scene, const char* name, const Rgba& color) {
  const std::uint32_t material = add_material(scene, name, color);
  scene.materials[material].unlit = true;
  return material;
}

}  // namespace

Scene make_depth_ladder() {
  Scene scene;
  scene.name = "depth-ladder";
  Mesh back = make_squares("back", 0.09, 0);
  back.material = add_unlit(scene, "red", {0.75f, 0.03f, 0.03f, 1});
  add_object(scene, std::move(back));
  Mesh front = make_squares("front", 0.06, 0x1p-10);
  front.material = add_unlit(scene, "green", {0.05f, 0.55f, 0.1f, 1});
  add_object(scene, std::move(front));

  // At unit distance, the rows of rungs reach 0.4 above and below the direction of view, and the
  // window has the half height 0.45.
  PerspectiveLens lens;
  lens.fovy_radians = 2 * arctan(0.45);
  lens.near = 0.5;
  lens.far = 0x1p20;
  scene.cameras.push_back({"ladder", lens, Transform<World, Eye>()});
  return scene;
}

}  // namespace glassbox
