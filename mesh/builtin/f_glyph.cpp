#include <glassbox/mesh/builtin/f_glyph.h>

#include <glassbox/mesh/builtin/placement.h>
#include <glassbox/mesh/builtin/shapes.h>

namespace glassbox {

Scene make_f_glyph() {
  // The corners of the letter, counter-clockwise as seen from the front.
  constexpr std::array<std::array<double, 2>, 10> kOutline = {
      {{0, 0}, {1, 0}, {1, 2}, {2.5, 2}, {2.5, 3}, {1, 3}, {1, 4}, {3, 4}, {3, 5}, {0, 5}}};

  Scene scene;
  scene.name = "f-glyph";
  Mesh mesh;
  mesh.name = "F";
  const std::uint32_t yellow = add_color(mesh, {0.85f, 0.55f, 0.04f, 1});
  const std::uint32_t blue = add_color(mesh, {0.05f, 0.15f, 0.6f, 1});
  const std::uint32_t grey = add_color(mesh, {0.35f, 0.35f, 0.35f, 1});
  std::vector<std::uint32_t> front, back;
  for (const auto& p : kOutline) {
    front.push_back(add_position(mesh, p[0], p[1], 1));
    back.push_back(add_position(mesh, p[0], p[1], 0));
  }
  add_flat_face(mesh, front, yellow);
  add_flat_face(mesh, std::vector<std::uint32_t>(back.rbegin(), back.rend()), blue);
  for (std::size_t i = 0; i < kOutline.size(); ++i) {
    const std::size_t next = (i + 1) % kOutline.size();
    const std::array<std::uint32_t, 4> side = {front[i], back[i], back[next], front[next]};
    add_flat_face(mesh, side, grey);
  }
  mesh.material = add_material(scene, "painted", {1, 1, 1, 1});
  add_object(scene, std::move(mesh));
  return scene;
}

}  // namespace glassbox
