// Changes of a scene that must not change its picture.
#include <algorithm>
#include <cmath>

#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/render/staged/staged.h>

#include "tests/render/scenes.h"
#include "tests/support/catch.h"

namespace glassbox {
namespace {

constexpr double kAspect = 160.0 / 120;

Rendering render(const Scene& scene, const Camera& camera, const RenderSettings& settings = {}) {
  const auto view = make_view(camera, 160, 120);
  REQUIRE(view);
  return render_staged(scene, *view, settings);
}

// The scene scaled by a power of two, with all that is measured in its units.
Scene scaled(Scene scene, double scale) {
  for (Mesh& mesh : scene.meshes) {
    for (auto& p : mesh.positions) {
      p = {float(p.x * scale), float(p.y * scale), float(p.z * scale)};
    }
  }
  for (Node& node : scene.nodes) {
    for (int row = 0; row < 3; ++row) {
      node.parent_from_node.at(row, 3) *= scale;
      node.world_from_node.at(row, 3) *= scale;
    }
  }
  for (Light& light : scene.lights) {
    light.position = {light.position.x * scale, light.position.y * scale, light.position.z * scale};
    if (light.kind != LightKind::kDirectional) light.intensity *= scale * scale;
    if (light.range) *light.range *= scale;
  }
  return scene;
}

Camera scaled(Camera camera, double scale) {
  for (int row = 0; row < 3; ++row) camera.world_from_eye.at(row, 3) *= scale;
  auto& lens = std::get<PerspectiveLens>(camera.lens);
  lens.near *= scale;
  if (lens.far) *lens.far *= scale;
  return camera;
}

// The share of the faces that is culled, "about half" in S4.37: half for the cube seen over a
// corner; for a sphere of radius 1 seen from distance d all but the cap of height 1 - 1/d.
double culled_share(const std::string& name, const Camera& camera) {
  if (name == "cube") return 0.5;
  const auto& m = camera.world_from_eye;
  const double d =
      std::sqrt(m.at(0, 3) * m.at(0, 3) + m.at(1, 3) * m.at(1, 3) + m.at(2, 3) * m.at(2, 3));
  return 0.5 + 0.5 / d;
}

}  // namespace

TEST_CASE("a scene and its camera scaled by a power of two give the same bytes") {
  for (const char* name : {"teapot:4", "cube", "f-glyph", "room"}) {
    for (const double scale : {0x1p-20, 0.5, 0x1p20}) {
      INFO(name << " scaled by " << scale);
      const Scene scene = test::built_in(name);
      const Camera camera = test::camera_for(scene, kAspect);
      const Rendering a = render(scene, camera);
      const Rendering b = render(scaled(scene, scale), scaled(camera, scale));
      CHECK(a.buffers.color == b.buffers.color);
      CHECK(a.buffers.depth == b.buffers.depth);
    }
  }
}

TEST_CASE("the order of triangles does not matter where no two depths tie") {
  const Scene scene = test::built_in("teapot:6");
  Scene reversed = scene;
  for (Mesh& mesh : reversed.meshes) std::reverse(mesh.faces.begin(), mesh.faces.end());
  RenderSettings settings;
  settings.shading = Shading::kUnlit;
  const Camera camera = test::camera_for(scene, kAspect);
  const Rendering a = render(scene, camera, settings);
  const Rendering b = render(reversed, camera, settings);
  CHECK(a.buffers.depth == b.buffers.depth);
  CHECK(a.buffers.color == b.buffers.color);
}

TEST_CASE("a closed convex solid looks the same with and without back-face culling (C-30, S4-19)") {
  for (const char* name : {"cube", "sphere"}) {
    INFO(name);
    const Scene scene = test::built_in(name);
    RenderSettings culled, whole;
    culled.cull = Cull::kBack;
    whole.cull = Cull::kNone;
    const Camera camera = test::camera_for(scene, kAspect);
    const Rendering a = render(scene, camera, culled);
    const Rendering b = render(scene, camera, whole);
    CHECK(a.buffers.color == b.buffers.color);
    CHECK(a.buffers.depth == b.buffers.depth);
    const double share =
        double(a.statistics.culled) / double(a.statistics.after_clipping - a.statistics.zero_area);
    // The sphere has 64 bands of faces; the silhouette may be within two of them.
    CHECK(std::abs(share - culled_share(name, camera)) < 2.0 / 64);
  }
}

TEST_CASE("of two triangles in the same place the first one drawn stays (C-58)") {
  Mesh mesh;
  mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  test::add_face(mesh, {0, 1, 2});
  test::add_face(mesh, {0, 1, 2});
  RenderSettings settings;
  settings.want_id = true;
  const Camera camera{"front", PerspectiveLens{1, 0.1, 10.0},
                      inverse_rigid(*look_at({0, 0, 3}, {0, 0, 0}, {0, 1, 0}))};
  const Rendering rendering = render(test::scene_of(mesh), camera, settings);
  const auto& ids = rendering.buffers.id.pixels;
  CHECK(std::ranges::count(ids, 1u) > 0);
  CHECK(std::ranges::count(ids, 2u) == 0);
}

}  // namespace glassbox
