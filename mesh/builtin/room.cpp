#include <glassbox/mesh/builtin/room.h>

#include <glassbox/base/trig.h>
#include <glassbox/mesh/builtin/images.h>
#include <glassbox/mesh/builtin/placement.h>
#include <glassbox/mesh/builtin/shapes.h>

namespace glassbox {
namespace {

// The room extends from (-3, 0, -5) to (3, 3, 0); the window from (0.4, 1) to (2, 2.2) in the wall
// z = -5.
constexpr double kLeft = -3, kRight = 3, kHeight = 3, kBack = -5;
constexpr double kWindowLeft = 0.4, kWindowRight = 2, kSill = 1, kLintel = 2.2, kOutside = -5.25;

Mesh make_floor() {
  Mesh mesh;
  mesh.name = "floor";
  add_rectangle(mesh, {kLeft, 0, 0}, {6, 0, 0}, {0, 0, -5}, 3, 2.5);
  return mesh;
}

Mesh make_ceiling() {
  Mesh mesh;
  mesh.name = "ceiling";
  add_rectangle(mesh, {kLeft, kHeight, kBack}, {6, 0, 0}, {0, 0, 5});
  return mesh;
}

// The wall around the window is four quads from the corners of the wall to the corners of the
// opening, so that every edge has exactly one neighbour along its whole length and no corner is
// inside another quad's edge.
void add_window_wall(Mesh& mesh) {
  const std::array<std::array<double, 2>, 8> corners = {{{kLeft, 0},
                                                         {kRight, 0},
                                                         {kRight, kHeight},
                                                         {kLeft, kHeight},
                                                         {kWindowLeft, kSill},
                                                         {kWindowRight, kSill},
                                                         {kWindowRight, kLintel},
                                                         {kWindowLeft, kLintel}}};
  std::array<std::uint32_t, 8> p, t;
  for (std::size_t i = 0; i < 8; ++i) {
    p[i] = add_position(mesh, corners[i][0], corners[i][1], kBack);
    t[i] = add_texcoord(mesh, corners[i][0], kHeight - corners[i][1]);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    const std::array<std::uint32_t, 4> positions = {p[i], p[next], p[next + 4], p[i + 4]};
    const std::array<std::uint32_t, 4> texcoords = {t[i], t[next], t[next + 4], t[i + 4]};
    add_flat_face(mesh, positions, kNone, texcoords);
  }
}

Mesh make_walls() {
  Mesh mesh;
  mesh.name = "walls";
  add_window_wall(mesh);
  add_rectangle(mesh, {kLeft, 0, 0}, {0, 0, kBack}, {0, kHeight, 0}, 5, 3);
  add_rectangle(mesh, {kRight, 0, kBack}, {0, 0, -kBack}, {0, kHeight, 0}, 5, 3);
  add_rectangle(mesh, {kRight, 0, 0}, {-6, 0, 0}, {0, kHeight, 0}, 6, 3);
  return mesh;
}

// The four sides of the opening, as deep as the wall is thick.
Mesh make_window_frame() {
  Mesh mesh;
  mesh.name = "window frame";
  constexpr double kThickness = kBack - kOutside, kWidth = kWindowRight - kWindowLeft,
                   kOpening = kLintel - kSill;
  add_rectangle(mesh, {kWindowLeft, kSill, kBack}, {kWidth, 0, 0}, {0, 0, -kThickness});
  add_rectangle(mesh, {kWindowLeft, kLintel, kOutside}, {kWidth, 0, 0}, {0, 0, kThickness});
  add_rectangle(mesh, {kWindowLeft, kSill, kBack}, {0, 0, -kThickness}, {0, kOpening, 0});
  add_rectangle(mesh, {kWindowRight, kSill, kOutside}, {0, 0, kThickness}, {0, kOpening, 0});
  // The window has a cross of bars near its outer side.
  constexpr double kMiddle = (kWindowLeft + kWindowRight) / 2, kCrossbar = kSill + 0.8;
  add_box(mesh, {kMiddle - 0.025, kSill, kOutside + 0.04},
          {kMiddle + 0.025, kLintel, kOutside + 0.09});
  add_box(mesh, {kWindowLeft, kCrossbar - 0.025, kOutside + 0.045},
          {kWindowRight, kCrossbar + 0.025, kOutside + 0.085});
  return mesh;
}

Mesh make_sky() {
  Mesh mesh;
  mesh.name = "sky";
  add_rectangle(mesh, {-6, -3, -9}, {14, 0, 0}, {0, 10, 0});
  return mesh;
}

// A slab on four legs; the slab's top is at `height`.
Mesh make_table(const char* name, double width, double depth, double height, double leg) {
  Mesh mesh;
  mesh.name = name;
  const double x = width / 2, z = depth / 2, under = height - leg;
  add_box(mesh, {-x, under, -z}, {x, height, z});
  for (const double side : {-1.0, 1.0}) {
    for (const double end : {-1.0, 1.0}) {
      const double cx = side * (x - leg), cz = end * (z - leg), half = leg / 2;
      add_box(mesh, {cx - half, 0, cz - half}, {cx + half, under, cz + half});
    }
  }
  return mesh;
}

Mesh make_shelf() {
  Mesh mesh;
  mesh.name = "shelf";
  add_box(mesh, {-0.6, 0, -0.15}, {-0.56, 2, 0.15});
  add_box(mesh, {0.56, 0, -0.15}, {0.6, 2, 0.15});
  for (int board = 0; board < 5; ++board) {
    const double y = 0.1 + 0.45 * board;
    add_box(mesh, {-0.56, y, -0.14}, {0.56, y + 0.03, 0.14});
  }
  return mesh;
}

// Books of different heights, thicknesses and colours on the lower four boards of the shelf.
Mesh make_books() {
  Mesh mesh;
  mesh.name = "books";
  const std::array<std::uint32_t, 4> covers = {
      add_color(mesh, {0.45f, 0.06f, 0.05f, 1}), add_color(mesh, {0.06f, 0.14f, 0.35f, 1}),
      add_color(mesh, {0.07f, 0.25f, 0.12f, 1}), add_color(mesh, {0.55f, 0.4f, 0.15f, 1})};
  std::uint64_t book = 0;
  for (int board = 0; board < 4; ++board) {
    const double y = 0.13 + 0.45 * board;
    const double end = 0.5 - 0.5 * random_unit(21, std::uint64_t(board));
    for (double x = -0.54; x < end; ++book) {
      const double thickness = 0.03 + 0.04 * random_unit(22, book);
      const double height = 0.22 + 0.14 * random_unit(23, book);
      const std::uint32_t cover = covers[scramble(book) % covers.size()];
      add_box(mesh, {x, y, -0.1}, {x + thickness, y + height, 0.11},
              {cover, cover, cover, cover, cover, cover});
      x += thickness + 0.004;
    }
  }
  return mesh;
}

Mesh make_lampshade() {
  Mesh mesh;
  mesh.name = "lampshade";
  add_tube(mesh, 0.28, 0.1, 2.05, 2.3, 24);
  add_tube(mesh, 0.008, 0.008, 2.3, kHeight, 8);
  return mesh;
}

Mesh with_material(Mesh mesh, std::uint32_t material) {
  mesh.material = material;
  return mesh;
}

void add_lights(Scene& scene) {
  Light lamp;
  lamp.name = "lamp";
  lamp.kind = LightKind::kPoint;
  lamp.color = {1, 0.88f, 0.7f};
  lamp.intensity = 9;
  lamp.position = {-0.4, 2.0, -2.9};
  scene.lights.push_back(lamp);
  add_directional(scene, "window", {-0.35, -0.55, 1}, 0.5, {0.7f, 0.85f, 1});
  add_directional(scene, "bounce", {0.2, 0.7, -1}, 0.35);
}

}  // namespace

Scene make_room() {
  Scene scene;
  scene.name = "room";
  const std::uint32_t boards = add_material(scene, "boards", {1, 1, 1, 1});
  scene.materials[boards].texture = add_texture(scene, make_boards({170, 122, 78}, 31));
  const std::uint32_t paper = add_material(scene, "wallpaper", {1, 1, 1, 1});
  scene.materials[paper].texture =
      add_texture(scene, make_checks(8, 16, {206, 200, 176}, {196, 188, 160}));
  const std::uint32_t plaster = add_material(scene, "plaster", {0.8f, 0.8f, 0.78f, 1});
  const std::uint32_t paint = add_material(scene, "white paint", {0.85f, 0.85f, 0.85f, 1});
  const std::uint32_t oak = add_material(scene, "oak", {0.32f, 0.17f, 0.07f, 1});
  scene.materials[oak].specular = {0.12f, 0.12f, 0.12f};
  const std::uint32_t covers = add_material(scene, "book covers", {1, 1, 1, 1});
  const std::uint32_t cloth = add_material(scene, "lampshade", {0.75f, 0.5f, 0.2f, 1});
  scene.materials[cloth].double_sided = true;
  const std::uint32_t sky = add_material(scene, "sky", {0.35f, 0.58f, 0.9f, 1});
  scene.materials[sky].unlit = true;

  add_object(scene, with_material(make_floor(), boards));
  add_object(scene, with_material(make_ceiling(), plaster));
  add_object(scene, with_material(make_walls(), paper));
  add_object(scene, with_material(make_window_frame(), paint));
  add_object(scene, with_material(make_sky(), sky));
  add_object(scene, with_material(make_table("table", 1.6, 0.9, 0.75, 0.07), oak),
             placement_transform({-0.4, 0, -2.9}, 12));
  const std::uint32_t stool =
      add_object(scene, with_material(make_table("stool", 0.4, 0.4, 0.45, 0.05), oak),
                 placement_transform({0.9, 0, -2.3}, 25));
  add_instance(scene, stool, "second stool", placement_transform({-1.0, 0, -1.9}, -20));
  const Transform<World, Object> by_the_wall = placement_transform({-1.9, 0, -4.83});
  add_object(scene, with_material(make_shelf(), oak), by_the_wall);
  add_object(scene, with_material(make_books(), covers), by_the_wall);
  add_object(scene, with_material(make_lampshade(), cloth), placement_transform({-0.4, 0, -2.9}));

  add_perspective(scene, "door", 55, 0.05, look_at_pose({1.6, 1.6, -0.25}, {-0.35, 1.15, -4}));
  add_lights(scene);
  return scene;
}

}  // namespace glassbox
