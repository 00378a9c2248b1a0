#include "study/extremes/common/drawn_normals.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <glassbox/mesh/triangulate.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/view.h>

#include "study/extremes/common/drawn_coverage.h"

namespace glassbox::study {

namespace {

constexpr int kTestMeshPixels = 12;  // side of a mesh's square

// Whether a pixel shows a normal. The right byte is the one nearest to 255 (n/2 + 1/2) for each
// component n; the pipeline computes this in float with four rounding errors of numbers up to 1.
bool shows_normal(const Rgba8& color, const std::array<double, 3>& normal, double radians) {
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  const std::array<std::uint8_t, 3> found{color.r, color.g, color.b};
  for (std::size_t k = 0; k < 3; ++k) {
    const double n = length > 0 ? normal[k] / length : 0;
    const double off = std::abs(double(found[k]) - 255 * (n / 2 + 0.5));
    if (!(off <= 0.5 + 127.5 * radians + 255 * 0x1p-22)) return false;
  }
  return true;
}

}  // namespace

NormalTestMesh make_normal_test_mesh(Mesh mesh, const Transform<World, Object>& place,
                                     const Vector<Object, exact::Rational>& normal) {
  return {std::move(mesh), place, {double(normal.x), double(normal.y), double(normal.z)}};
}

Outcome measure_normal_error(const TestedEngine& engine, const std::vector<NormalTestMesh>& meshes,
                             Shading shading, double radians) {
  const int columns = int(std::ceil(std::sqrt(double(meshes.size()))));
  Scene scene;
  scene.materials = {Material{}};
  std::vector<std::size_t> owners;  // test mesh of each triangle, by triangle number
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const double x = 2 * double(int(i) % columns) - columns + 1;
    const double y = 2 * double(int(i) / columns) - columns + 1;
    Node node;
    node.world_from_node = node.parent_from_node =
        translate<World>(Vector<World, double>{x, y, -2}) * meshes[i].place;
    scene.nodes.push_back(node);
    scene.meshes.push_back(meshes[i].mesh);
    scene.instances.push_back({std::uint32_t(i), std::uint32_t(i)});
    owners.resize(owners.size() + triangulate(meshes[i].mesh).triangles.size(), i);
  }
  Camera camera;
  camera.lens = OrthographicLens{double(columns), 0, 4};
  const View view = make_view(camera, columns * kTestMeshPixels, columns * kTestMeshPixels).value();
  RenderSettings settings = plain_settings();
  settings.shading = shading;
  settings.show = Show::kNormal;
  const Framebuffer found = engine.draw(scene, view, settings).buffers;
  std::vector<int> seen(meshes.size());
  int wrong = 0, all = 0;
  for (std::size_t i = 0; i < found.id.pixels.size(); ++i) {
    const std::uint32_t id = found.id.pixels[i];
    if (id == 0) continue;
    const std::size_t owner = owners[id - 1];
    ++all;
    ++seen[owner];
    wrong += !shows_normal(found.color.pixels[i], meshes[owner].normal, radians);
  }
  Outcome outcome = wrong_count_outcome(wrong, all, "pixels show another normal");
  if (std::ranges::count(seen, 0) > 0) outcome.error = HUGE_VAL;
  return outcome;
}

}  // namespace glassbox::study
