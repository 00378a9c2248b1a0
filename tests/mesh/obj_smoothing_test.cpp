// Smoothing groups of OBJ files that have no normals.
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/mesh/normals.h>
#include <glassbox/mesh/obj/load.h>

#include "tests/support/catch.h"

namespace glassbox {
namespace {

Scene smoothed(const std::string& text) {
  auto scene = load_obj_memory(text, "newmtl a\nnewmtl b\n");
  INFO((scene ? "" : scene.error().message()));
  REQUIRE(scene);
  return std::move(*scene);
}

std::optional<Normal<Object>> corner_normal(const Mesh& mesh, std::uint32_t face, std::uint32_t i) {
  const Corner& corner = mesh.corners[mesh.faces[face].first + i];
  if (corner.normal == kNone) return std::nullopt;
  return mesh.normals[corner.normal];
}

// A roof: two sloping quads that share the ridge from vertex 3 to vertex 4.
const std::string kRoof = "v -1 -1 -1\nv -1 1 -1\nv 0 -1 0\nv 0 1 0\nv 1 -1 -1\nv 1 1 -1\n";

}  // namespace

TEST_CASE("OBJ: within a smoothing group the ridge of a roof has one normal, and the rest slopes") {
  const Mesh mesh = smoothed(kRoof + "s 1\nf 1 3 4 2\nf 3 5 6 4\n").meshes[0];
  CHECK(mesh.normals.size() == 6);
  CHECK(corner_normal(mesh, 0, 1) == Normal<Object>(0, 0, 1));
  CHECK(corner_normal(mesh, 1, 0) == Normal<Object>(0, 0, 1));
  const auto low = corner_normal(mesh, 0, 0);
  REQUIRE(low);
  CHECK(low->x == Approx(-std::sqrt(0.5)));
  CHECK(low->z == Approx(std::sqrt(0.5)));
}

TEST_CASE("OBJ: faces in different smoothing groups, in none, or without any stay apart") {
  const auto is_flat = [](const std::string& faces) {
    return smoothed(kRoof + faces).meshes[0].normals.empty();
  };
  CHECK(is_flat("f 1 3 4 2\nf 3 5 6 4\n"));
  CHECK(is_flat("s off\nf 1 3 4 2\nf 3 5 6 4\n"));
  CHECK(is_flat("s 0\nf 1 3 4 2\nf 3 5 6 4\n"));
  CHECK(is_flat("f 1 3 4 2\nf 3 5 6 4\ns 1\n"));

  const Mesh apart = smoothed(kRoof + "s 1\nf 1 3 4 2\ns 2\nf 3 5 6 4\n").meshes[0];
  CHECK(corner_normal(apart, 0, 1) == face_normal(apart, apart.faces[0]));
  CHECK(corner_normal(apart, 1, 0) == face_normal(apart, apart.faces[1]));
  const Mesh one_off = smoothed(kRoof + "s 1\nf 1 3 4 2\ns off\nf 3 5 6 4\n").meshes[0];
  CHECK(corner_normal(one_off, 0, 1) == face_normal(one_off, one_off.faces[0]));
  CHECK_FALSE(corner_normal(one_off, 1, 0));
}

TEST_CASE("OBJ: a smoothing group goes on across objects, groups and materials") {
  const Scene scene = smoothed(kRoof + "s 3\no x\nusemtl a\nf 1 3 4 2\no y\nusemtl b\nf 3 5 6 4\n");
  REQUIRE(scene.meshes.size() == 2);
  CHECK(corner_normal(scene.meshes[0], 0, 1) == Normal<Object>(0, 0, 1));
  CHECK(corner_normal(scene.meshes[1], 0, 0) == Normal<Object>(0, 0, 1));
}

TEST_CASE("OBJ: normals of the file count, and smoothing groups do not change them") {
  const std::string faces = "vn 1 0 0\ns 1\nf 1//1 3//1 4//1 2//1\nf 3 5 6 4\n";
  const Mesh mesh = smoothed(kRoof + faces).meshes[0];
  CHECK(corner_normal(mesh, 0, 1) == Normal<Object>(1, 0, 0));
  CHECK_FALSE(corner_normal(mesh, 1, 0));
}

TEST_CASE("OBJ: a smoothing group that is no number is named and taken as off") {
  const Scene scene = smoothed(kRoof + "s one\nf 1 3 4 2\ns -1\nf 3 5 6 4\n");
  CHECK(scene.meshes[0].normals.empty());
  REQUIRE(scene.warnings.size() == 1);
  CHECK(scene.warnings[0] ==
        "2 smoothing groups are neither numbers nor off, and were taken as off (first in line 7)");
  CHECK(smoothed(kRoof + "s on\nf 1 3 4 2\nf 3 5 6 4\n").meshes[0].normals.size() == 6);
}

TEST_CASE("OBJ: a corner whose faces cancel has no normal and is shaded flat") {
  const Mesh mesh = smoothed(kRoof + "s 1\nf 1 3 4 2\nf 2 4 3 1\n").meshes[0];
  CHECK(mesh.normals.empty());
}

TEST_CASE("OBJ: each vertex has one normal for each of its groups, in random meshes") {
  Random random(21);
  for (int trial = 0; trial < 200; ++trial) {
    const std::int64_t vertices = random.integer(3, 12);
    std::ostringstream text;
    for (std::int64_t i = 0; i < vertices; ++i) {
      const std::int64_t x = random.integer(-4, 4), y = random.integer(-4, 4);
      text << "v " << x << ' ' << y << ' ' << random.integer(-4, 4) << '\n';
    }
    std::vector<std::int64_t> groups;
    for (std::int64_t face = random.integer(1, 12); face > 0; --face) {
      groups.push_back(random.integer(0, 3));
      text << "s " << groups.back() << "\nf";
      for (std::int64_t i = random.integer(3, 5); i > 0; --i) {
        text << ' ' << random.integer(1, vertices);
      }
      text << '\n';
    }
    INFO(text.str());
    const Mesh mesh = smoothed(text.str()).meshes[0];
    std::map<std::pair<std::uint32_t, std::int64_t>, Vector<Object, double>> sums;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      const Face& face = mesh.faces[f];
      for (std::uint32_t i = face.first; i < face.first + face.count; ++i) {
        auto& sum = sums.try_emplace({mesh.corners[i].position, groups[f]}, 0, 0, 0).first->second;
        sum = sum + newell_vector(mesh, face);
      }
    }
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
      for (std::uint32_t i = 0; i < mesh.faces[f].count; ++i) {
        const auto normal = corner_normal(mesh, f, i);
        const std::uint32_t position = mesh.corners[mesh.faces[f].first + i].position;
        const auto expected = unit_normal(sums.at({position, groups[f]}));
        REQUIRE(normal.has_value() == (groups[f] != 0 && expected.has_value()));
        if (!normal) continue;
        CHECK(std::abs(normal->x - expected->x) < 1e-6f);
        CHECK(std::abs(normal->y - expected->y) < 1e-6f);
        CHECK(std::abs(normal->z - expected->z) < 1e-6f);
      }
    }
  }
}

}  // namespace glassbox
