// Triangles in a view in which every step is exact, and the verdicts on them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <glassbox/pipeline/view.h>
#include <glassbox/render/trace/scene_verdict.h>

#include "app/why/verdict_text.h"
#include "tests/render/scenes.h"
#include "tests/support/catch.h"
#include "tests/support/contains.h"

namespace glassbox::test {

// A picture of 64 x 64 pixels, seen from the origin along -z, 90 degrees wide: screen x = 32 + 32
// x/w, y = 32 - 32 y/w with w = -z. With near 1 and far 2, clip z = 2 w - 2.
inline constexpr int kSide = 64;

inline View plain_view(double near = 1, double far = 2) {
  const auto view =
      make_view({"", FrustumLens{-near, near, -near, near, near, far}, {}}, kSide, kSide);
  REQUIRE(view);
  return *view;
}

// The point at distance w that is drawn at (x, y) pixels; exact for multiples of 1/256 px and
// powers of two.
inline Point<Object> point_at_pixel(double x, double y, double w = 1) {
  return {float((x - 32) / 32 * w), float((32 - y) / 32 * w), float(-w)};
}

inline Material flat_material(const Rgba& color = {0.8f, 0.5f, 0.2f, 1},
                              AlphaMode mode = AlphaMode::kOpaque) {
  Material material;
  material.base_color = color;
  material.alpha_mode = mode;
  material.unlit = true;
  return material;
}

struct Part {
  std::vector<Point<Object>> corners;  // three for each triangle
  Material material = flat_material();
  Transform<World, Object> world_from_object;
};

// A scene whose instances are the parts, in this order, each with its own mesh.
inline Scene scene_of_parts(const std::vector<Part>& parts) {
  Scene scene;
  for (const Part& part : parts) {
    Mesh mesh;
    mesh.name = "part " + std::to_string(scene.meshes.size());
    mesh.positions = part.corners;
    for (std::uint32_t i = 0; i + 2 < part.corners.size(); i += 3) {
      add_face(mesh, {i, i + 1, i + 2});
    }
    mesh.material = std::uint32_t(scene.materials.size());
    scene.materials.push_back(part.material);
    const std::uint32_t index = std::uint32_t(scene.meshes.size());
    scene.nodes.push_back(Node{"", kNone, part.world_from_object, part.world_from_object});
    scene.instances.push_back({index, index});
    scene.meshes.push_back(std::move(mesh));
  }
  return scene;
}

// Half a square of `side` px whose right angle is at (x, y); counter-clockwise as seen, so its
// front.
inline std::vector<Point<Object>> half_square(double x, double y, double side, double w = 1) {
  return {point_at_pixel(x, y, w), point_at_pixel(x, y + side, w), point_at_pixel(x + side, y, w)};
}

inline std::vector<Point<Object>> with_reversed_winding(const std::vector<Point<Object>>& corners) {
  return {corners[0], corners[2], corners[1]};
}

inline TriangleVerdict checked_verdict(const Scene& scene, std::uint64_t number = 0,
                                       const View& view = plain_view(),
                                       const RenderSettings& settings = {}) {
  const auto verdict = triangle_verdict(scene, view, settings, number);
  REQUIRE(verdict);
  // The verdict can be explained and written as JSON, and the summary agrees with it.
  CHECK(!explain(view, *verdict).empty());
  CHECK(to_json(*verdict)["end"] == name_of(verdict->result));
  const SceneVerdict whole = scene_verdict(scene, view, settings);
  CHECK(whole.triangles == count_triangles(scene));
  CHECK(whole.at(verdict->result).triangles > 0);
  return *verdict;
}

inline TriangleVerdict checked_verdict(const std::vector<Point<Object>>& corners,
                                       const View& view = plain_view(),
                                       const RenderSettings& settings = {}) {
  return checked_verdict(scene_of_parts({{corners, flat_material(), {}}}), 0, view, settings);
}

inline std::string explanation_text(const View& view, const TriangleVerdict& verdict) {
  std::string all;
  for (const std::string& paragraph : explain(view, verdict)) all += paragraph + "\n";
  return all;
}

}  // namespace glassbox::test
