// Normals that point to the backs, and normals that were transformed like positions.
#include <glassbox/mesh/normal_check.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include <glassbox/base/random.h>
#include <glassbox/mesh/builtin/scenes.h>

#include "tests/support/catch.h"

namespace glassbox {
namespace {

Mesh mesh_of(const char* name) {
  const auto scene = make_builtin(name);
  REQUIRE(scene);
  return scene->meshes.front();
}

enum class By { kMatrix, kInverseTranspose };

// Scales the positions, and the normals by the same matrix or, as is right, by its inverse
// transpose.
void scale_mesh(Mesh& mesh, const glm::dvec3& s, By by) {
  for (Point<Object>& p : mesh.positions) {
    p = {float(p.x * s.x), float(p.y * s.y), float(p.z * s.z)};
  }
  for (Normal<Object>& n : mesh.normals) {
    const glm::dvec3 old(to_glm(n));
    n = Normal<Object>(glm::vec3(glm::normalize(by == By::kMatrix ? old * s : old / s)));
  }
}

TEST_CASE("normals of built-in scenes point to the fronts and fit the faces") {
  for (const char* name : {"teapot", "sphere", "cube", "f-glyph", "room", "forest"}) {
    const auto scene = make_builtin(name);
    REQUIRE(scene);
    for (const Mesh& mesh : scene->meshes) {
      const NormalReport report = normal_report(mesh);
      CAPTURE(name, mesh.name, report.corners, report.against_faces, report.degrees_off);
      CHECK_FALSE(report.inverted());
      CHECK_FALSE(report.scaled_by);
    }
  }
}

TEST_CASE("negated normals, and faces that were turned round, are found") {
  Mesh mesh = mesh_of("sphere");
  for (Normal<Object>& n : mesh.normals) n = {-n.x, -n.y, -n.z};
  NormalReport report = normal_report(mesh);
  CHECK(report.corners > 0);
  CHECK(report.against_faces == report.corners);
  CHECK(report.inverted());
  mesh = mesh_of("sphere");
  for (const Face& face : mesh.faces) {
    std::reverse(mesh.corners.begin() + face.first, mesh.corners.begin() + face.first + face.count);
  }
  CHECK(normal_report(mesh).inverted());
}

TEST_CASE("a scale by which the normals were multiplied as well is found; the right way is not") {
  Random random(465);
  for (int i = 0; i < 60; ++i) {
    const double x = std::exp(random.between(-1, 1)), y = std::exp(random.between(-1, 1));
    const double z = std::exp(random.between(-1, 1)), least = std::min({x, y, z});
    if (std::max({x, y, z}) < 1.5 * least) continue;
    const char* name = i % 2 == 0 ? "sphere" : "teapot";
    Mesh wrong = mesh_of(name), right = wrong;
    scale_mesh(wrong, {x, y, z}, By::kMatrix);
    scale_mesh(right, {x, y, z}, By::kInverseTranspose);
    const NormalReport found = normal_report(wrong);
    CAPTURE(name, x, y, z, found.degrees_off);
    CHECK_FALSE(normal_report(right).scaled_by);
    REQUIRE(found.scaled_by);
    const glm::dvec3 expected = glm::dvec3(x, y, z) / least;
    for (int k = 0; k < 3; ++k) CHECK((*found.scaled_by)[k] == Approx(expected[k]).epsilon(0.1));
  }
}

TEST_CASE("a mesh without normals, or without area, has none to compare") {
  Mesh mesh = mesh_of("cube");
  mesh.normals.clear();
  for (Corner& corner : mesh.corners) corner.normal = kNone;
  CHECK(normal_report(mesh).corners == 0);
  Mesh flat = mesh_of("sphere");
  for (Point<Object>& p : flat.positions) p = {0, 0, 0};
  CHECK(normal_report(flat).corners == 0);
  CHECK_FALSE(normal_report(flat).inverted());
}

}  // namespace
}  // namespace glassbox
