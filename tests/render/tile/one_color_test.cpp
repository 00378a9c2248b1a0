// Large triangles whose pixels all have one colour are shaded once; whether they do is decided by
// the attributes of their corners.
#include <algorithm>
#include <bit>

#include "tests/render/tile/same_picture.h"

namespace glassbox {
namespace {

using namespace test;

// A quad that fills most of the view; every corner has its own normal and colour entry.
Mesh pane() {
  Mesh mesh;
  mesh.positions = {{-3, -2, -4}, {3, -2, -4}, {3, 2, -5}, {-3, 2, -5}};
  for (std::uint32_t i = 0; i < 4; ++i) {
    mesh.normals.push_back({0.1f, 0.2f, 0.97f});
    mesh.colors.push_back({0.7f, 0.6f, 0.5f, 1});
    mesh.corners.push_back({i, i, kNone, i});
  }
  mesh.faces.push_back({0, 4});
  return mesh;
}

View front_view() {
  const auto view = make_view(Camera{"test", PerspectiveLens{0.9, 0.5, 20.0}, {}}, 130, 70,
                              DepthRange::kStandard);
  REQUIRE(view);
  return *view;
}

int colors_in(const Image<Rgba8>& picture) {
  std::vector<std::uint32_t> all;
  for (const Rgba8& c : picture.pixels) all.push_back(std::bit_cast<std::uint32_t>(c));
  std::ranges::sort(all);
  return int(std::distance(all.begin(), std::unique(all.begin(), all.end())));
}

// Checks that both engines give the same bytes. Returns how many colours the picture has.
int check_pane(const Mesh& mesh, const Material& material, Shading shading,
               std::vector<Light> lights = {}) {
  Scene scene = scene_of(mesh, material);
  scene.lights = std::move(lights);
  RenderSettings settings;
  settings.shading = shading;
  for (const int samples : {1, 4}) {
    settings.samples = samples;
    check_same(scene, front_view(), settings);
  }
  settings.samples = 1;
  return colors_in(render_staged(scene, front_view(), settings).buffers.color);
}

TEST_CASE("what is equal at all corners gives one colour, and what differs does not") {
  Material matte;
  matte.double_sided = true;
  Mesh equal = pane(), other_normal = pane(), other_color = pane(), no_normal = pane();
  other_normal.normals[2] = {0.6f, -0.1f, 0.8f};
  other_color.colors[1] = {0.2f, 0.6f, 0.5f, 1};
  no_normal.normals[0] = {0, 0, 0};
  for (const Shading shading :
       {Shading::kUnlit, Shading::kFlat, Shading::kGouraud, Shading::kPhong}) {
    INFO("shading " << int(shading));
    const bool smooth = shading == Shading::kGouraud || shading == Shading::kPhong;
    CHECK(check_pane(equal, matte, shading) == 2);  // one for the pane, one for the background
    CHECK((check_pane(other_normal, matte, shading) > 2) == smooth);
    // With Phong shading the interpolated normal keeps its direction, because the others agree.
    CHECK((check_pane(no_normal, matte, shading) > 2) == (shading == Shading::kGouraud));
    CHECK(check_pane(other_color, matte, shading) > 2);
  }
}

TEST_CASE("where light depends on the place, nothing is one colour") {
  Material shiny;
  shiny.specular = {0.5f, 0.5f, 0.5f};
  shiny.shininess = 20;
  CHECK(check_pane(pane(), shiny, Shading::kPhong) > 2);
  Light lamp;
  lamp.kind = LightKind::kPoint;
  lamp.position = {0.5, 0.5, -3};
  lamp.intensity = 20;
  CHECK(check_pane(pane(), {}, Shading::kPhong, {lamp}) > 2);
  Light sun;
  sun.direction = {0, 0, -1};
  sun.intensity = 3;
  Material glowing;
  glowing.emission = {0.1f, 0.05f, 0.2f};
  CHECK(check_pane(pane(), glowing, Shading::kPhong, {sun}) == 2);
}

// ---- blended over what is there ----

// Three panes of one colour, one behind the other, in front of a wall that has all bytes in all
// channels and leaves some of the background free.
Scene panes_before_wall(float alpha) {
  Mesh wall = pane();
  for (Point<Object>& p : wall.positions) p = {p.x * 0.8f, p.y * 0.8f, p.z - 3};
  wall.colors = {{0, 0, 1, 1}, {1, 0, 0.3f, 1}, {0.02f, 1, 0, 1}, {1, 1, 1, 1}};
  Material glass;
  glass.alpha_mode = AlphaMode::kBlend;
  glass.base_color = {0.9f, 0.5f, 0.2f, alpha};
  glass.double_sided = true;
  Material matte;
  matte.double_sided = true;
  Scene scene = scene_of(wall, matte);
  scene.materials.push_back(glass);
  for (int i = 0; i < 3; ++i) {
    Mesh mesh = pane();
    for (Point<Object>& p : mesh.positions) p = {p.x + 0.4f * float(i), p.y, p.z - 0.5f * float(i)};
    mesh.material = 1;
    scene.instances.push_back({std::uint32_t(scene.meshes.size()), 0});
    scene.meshes.push_back(mesh);
  }
  return scene;
}

TEST_CASE("one colour laid over every byte gives the reference's, whatever is drawn and kept") {
  Light sun;
  sun.direction = {0, 0, -1};
  sun.intensity = 2;
  const ColorMask masks[] = {
      {}, {true, false, false, false}, {false, true, true, false}, {false, false, false, true}};
  for (const float alpha : {0.0f, 0.3f, 1.0f}) {
    Scene scene = panes_before_wall(alpha);
    scene.lights = {sun};
    for (const Transfer transfer : {Transfer::kSrgb, Transfer::kNone}) {
      for (const ColorMask& mask : masks) {
        RenderSettings settings;
        settings.transfer = transfer;
        settings.mask = mask;
        settings.background = {90, 3, 250, 77};
        INFO("alpha " << alpha << ", transfer " << int(transfer) << ", mask " << mask.r << mask.g
                      << mask.b << mask.a);
        for (const Target target : available_targets()) {
          check_same(scene, front_view(), settings, {.target = target});
        }
        settings.samples = 4;
        check_same(scene, front_view(), settings);
        settings.samples = 1;
        settings.want_distance = settings.want_id = true;
        check_same(scene, front_view(), settings);
      }
    }
  }
}

}  // namespace
}  // namespace glassbox
