// Large triangles whose pixels all have one colour are shaded once; which do not is found from what their corners have.
#include <algorithm>
#include <bit>

#include "tests/render/tile/same_picture.h"

namespace glassbox {
namespace {

using namespace test;

// Fills most of the view; every corner has a normal and a colour of its own.
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

// The same bytes by both engines; returns how many colours the picture has.
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
    CHECK(check_pane(equal, matte, shading) == 2);  // and the background
    CHECK((check_pane(other_normal, matte, shading) > 2) == smooth);
    // (Interpolated, the others' normal keeps its direction.)
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

}  // namespace
}  // namespace glassbox
