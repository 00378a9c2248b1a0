#include <glassbox/mesh/builtin/checker.h>

#include <glassbox/mesh/builtin/images.h>
#include <glassbox/mesh/builtin/placement.h>
#include <glassbox/mesh/builtin/shapes.h>

namespace glassbox {

Scene make_checker() {
  Scene scene;
  scene.name = "checker";
  const std::uint32_t material = add_material(scene, "checks", {1, 1, 1, 1});
  scene.materials[material].texture =
      add_texture(scene, make_checks(8, 32, {232, 228, 216}, {36, 40, 52}));
  scene.materials[material].unlit = true;

  Mesh floor;
  floor.name = "floor";
  floor.material = material;
  // The image has 8 x 8 squares. It is repeated 512 times along 4096 units, so a square is 1 unit
  // wide.
  add_rectangle(floor, {-2048, 0, 2048}, {4096, 0, 0}, {0, 0, -4096}, 512, 512);
  add_object(scene, std::move(floor));
  add_perspective(scene, "level", 50, 0.125, look_at_pose({0.3, 1.5, 0}, {0.3, 1.5, -1}));
  return scene;
}

}  // namespace glassbox
