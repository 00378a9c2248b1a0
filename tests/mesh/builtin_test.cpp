#include <glassbox/mesh/builtin/scenes.h>

#include <algorithm>
#include <cmath>

#include <glassbox/mesh/bounding_box.h>
#include <glassbox/mesh/builtin/images.h>
#include <glassbox/mesh/builtin/placement.h>
#include <glassbox/mesh/builtin/sphere.h>
#include <glassbox/mesh/builtin/teapot.h>
#include <glassbox/mesh/builtin/teapot_data.h>
#include <glassbox/mesh/check.h>
#include <glassbox/mesh/normals.h>
#include <glassbox/mesh/topology.h>
#include <glassbox/mesh/triangulate.h>

#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

bool in_range(std::uint32_t index, std::size_t size) {
  return index == kNone || index < size;
}

// A component has an error of half an ulp, at most 2^-24 / 2, so the squared length is off by at
// most 2 * 2^-24; the errors of the doubles that it was computed in are negligible.
bool is_unit(const Normal<Object>& n) {
  const double squared = double(n.x) * n.x + double(n.y) * n.y + double(n.z) * n.z;
  return std::abs(squared - 1) <= 0x1.001p-23;
}

void check_mesh(const Scene& scene, const Mesh& mesh) {
  CAPTURE(mesh.name);
  CHECK(mesh.material < scene.materials.size());
  bool positions_finite = true, corners_in_range = true, faces_in_range = true, normals_unit = true;
  for (const auto& p : mesh.positions) {
    positions_finite =
        positions_finite && std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  }
  for (const auto& n : mesh.normals) normals_unit = normals_unit && is_unit(n);
  for (const Corner& c : mesh.corners) {
    corners_in_range = corners_in_range && c.position < mesh.positions.size() &&
                       in_range(c.normal, mesh.normals.size()) &&
                       in_range(c.texcoord, mesh.texcoords.size()) &&
                       in_range(c.color, mesh.colors.size());
  }
  for (const Face& f : mesh.faces)
    faces_in_range = faces_in_range && f.first + f.count <= mesh.corners.size();
  CHECK(positions_finite);
  CHECK(normals_unit);
  REQUIRE(corners_in_range);
  REQUIRE(faces_in_range);

  const MeshReport report = mesh_report(mesh);
  CHECK(report.degenerate_faces == 0);
  CHECK(report.degenerate_triangles == 0);
  CHECK(report.self_intersecting_faces == 0);
  CHECK(report.inconsistent_edges == 0);
  CHECK(report.unused_positions == 0);
  CHECK(report.duplicate_faces == 0);
  CHECK(report.non_planar_faces == 0);
}

// Six times the volume of a closed mesh; positive if its faces look outwards.
double signed_volume(const Mesh& mesh) {
  double sum = 0;
  for (const Triangle& t : triangulate(mesh).triangles) {
    std::array<Vector<Object, double>, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point<Object>& q = mesh.positions[mesh.corners[t.corners[i]].position];
      p[i] = {q.x, q.y, q.z};
    }
    sum += dot(cross(p[0], p[1]), p[2]);
  }
  return sum;
}

Vector<Object, double> as_vector(const Normal<Object>& n) {
  return {n.x, n.y, n.z};
}

TEST_CASE("every built-in scene is finite, in range and without faults") {
  for (const BuiltinScene& builtin : builtin_scenes()) {
    const std::string name(builtin.name);
    CAPTURE(name);
    const Result<Scene> scene = make_builtin(name);
    REQUIRE(scene.has_value());
    CHECK(scene->name == name);
    CHECK(scene->file.empty());
    CHECK(scene->warnings.empty());
    REQUIRE_FALSE(scene->materials.empty());
    REQUIRE_FALSE(scene->instances.empty());
    CHECK_FALSE(bounds(*scene).empty());
    for (const Mesh& mesh : scene->meshes) check_mesh(*scene, mesh);
    for (const Instance& instance : scene->instances) {
      CHECK(instance.mesh < scene->meshes.size());
      CHECK(instance.node < scene->nodes.size());
    }
    for (const Material& material : scene->materials) {
      if (material.texture) CHECK(*material.texture < scene->textures.size());
    }
    for (const Texture& texture : scene->textures) CHECK(texture.image < scene->images.size());
    for (const Light& light : scene->lights) {
      if (light.kind == LightKind::kDirectional)
        CHECK(std::abs(dot(light.direction, light.direction) - 1) < 1e-15);
    }
  }
}

TEST_CASE(
    "built-in scenes with a place to stand have a rigid camera there; single objects are framed") {
  for (const BuiltinScene& builtin : builtin_scenes()) {
    const std::string name(builtin.name);
    CAPTURE(name);
    const Scene scene = *make_builtin(name);
    const bool is_place = name == "forest" || name == "room" || name == "checker" ||
                          name == "thicket" || name == "depth-ladder";
    REQUIRE(scene.cameras.size() == (is_place ? 1 : 0));
    if (!is_place) continue;
    const Transform<World, Eye>& pose = scene.cameras[0].world_from_eye;
    std::array<Vector<World, double>, 3> axes;
    for (int i = 0; i < 3; ++i)
      axes[std::size_t(i)] = {pose.at(0, i), pose.at(1, i), pose.at(2, i)};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) CHECK(std::abs(dot(axes[i], axes[j]) - (i == j)) < 1e-15);
    }
    CHECK(dot(cross(axes[0], axes[1]), axes[2]) > 0);
    // Some of the scene is in front of the eye.
    const Box<World> box = bounds(scene);
    double nearest = 0;
    for (int i = 0; i < 8; ++i) {
      const Point<World, double> eye(pose.at(0, 3), pose.at(1, 3), pose.at(2, 3));
      nearest = std::max(nearest, -dot(axes[2], box.corner(i) - eye));
    }
    CHECK(nearest > 0);
  }
}

TEST_CASE("closed built-in shapes are closed and look outwards") {
  for (const char* name : {"cube", "sphere", "sphere:2", "sphere:5", "f-glyph"}) {
    CAPTURE(name);
    const Scene scene = *make_builtin(name);
    const Mesh& mesh = scene.meshes[0];
    const Topology topology = find_topology(mesh);  // by index: no welding is needed
    CHECK(topology.closed());
    CHECK(topology.euler_characteristic() == 2);
    CHECK(topology.genus() == 0u);
    CHECK(signed_volume(mesh) > 0);
  }
  CHECK(signed_volume(make_builtin("cube")->meshes[0]) == 6 * 8.0);
  CHECK(signed_volume(make_builtin("f-glyph")->meshes[0]) == 6 * 8.5);
}

TEST_CASE("the teapot's numbers are mirror-symmetric and each stands once") {
  for (const auto& p : kTeapotPoints) {
    const std::array<double, 3> mirrored = {p[0], -p[1], p[2]};
    CAPTURE(p[0], p[1], p[2]);
    CHECK(std::find(kTeapotPoints.begin(), kTeapotPoints.end(), mirrored) != kTeapotPoints.end());
    CHECK(std::count(kTeapotPoints.begin(), kTeapotPoints.end(), p) == 1);
  }
}

TEST_CASE("the teapot is watertight at every level but for the model's own borders") {
  for (const int level : {2, 3, 5, 8, 16, 33}) {
    CAPTURE(level);
    const Mesh mesh = tessellate_teapot(level);
    const auto n = std::uint32_t(level);
    const Topology topology = find_topology(mesh);
    // The rim, the lid and the handle have four boundary curves each, each end of the spout has
    // two.
    CHECK(topology.boundary_edges == 16 * n);
    CHECK(topology.non_manifold_edges == 0);
    CHECK(topology.inconsistent_edges == 0);
    CHECK(topology.pinched_vertices ==
          1);                         // the handle's lower end touches the body at (-2, 0.9, 0)
    CHECK(topology.components == 4);  // body, handle, spout, lid
    // Welding by position merges nothing more: no two positions are the same.
    CHECK(find_topology(mesh, Weld::kByCoordinates).vertices == topology.vertices);
    // Two triangles for each cell, but one in the first row of the eight patches that start in a
    // point.
    CHECK(mesh.faces.size() == 32 * 2 * n * n - 8 * n);
    CHECK(triangulate(mesh).triangles.size() == mesh.faces.size());
    CHECK(signed_volume(mesh) > 0);
  }
}

TEST_CASE("at level 1 the handle and the spout are flat and some of their triangles have no area") {
  const Triangulation t = triangulate(tessellate_teapot(1));
  CHECK(t.numbered == 56);
  CHECK(t.degenerate_faces.size() == 4);
  CHECK(t.triangles.size() == 52);
}

TEST_CASE("the teapot's normals stand on its faces, at the poles too") {
  const Mesh mesh = tessellate_teapot(24);
  double worst = 1;
  for (const Face& face : mesh.faces) {
    const auto flat = face_normal(mesh, face);
    REQUIRE(flat.has_value());
    for (std::uint32_t i = 0; i < face.count; ++i) {
      const Normal<Object>& smooth = mesh.normals[mesh.corners[face.first + i].normal];
      worst = std::min(worst, dot(as_vector(*flat), as_vector(smooth)));
    }
  }
  // The surface bends by less than 60 degrees within a triangle, even on the lid's knob.
  CHECK(worst > 0.5);
  for (std::size_t i = 0; i < mesh.corners.size(); ++i) {
    const Corner& c = mesh.corners[i];
    const Point<Object>& p = mesh.positions[c.position];
    if (p.x == 0 && p.z == 0 && p.y == 0) CHECK(mesh.normals[c.normal] == Normal<Object>(0, -1, 0));
    if (p.x == 0 && p.z == 0 && p.y > 3) CHECK(mesh.normals[c.normal] == Normal<Object>(0, 1, 0));
  }
}

TEST_CASE("the sphere's positions and normals lie on the unit ball") {
  const Scene scene = make_sphere(17);
  const Mesh& mesh = scene.meshes[0];
  for (const auto& p : mesh.positions) CHECK(is_unit(Normal<Object>(p.x, p.y, p.z)));
}

TEST_CASE("the same name gives the same scene, number for number") {
  for (const BuiltinScene& builtin : builtin_scenes()) {
    const Scene a = *make_builtin(builtin.name), b = *make_builtin(builtin.name);
    REQUIRE(a.meshes.size() == b.meshes.size());
    for (std::size_t i = 0; i < a.meshes.size(); ++i) {
      CHECK(a.meshes[i].positions == b.meshes[i].positions);
      CHECK(a.meshes[i].corners == b.meshes[i].corners);
    }
    CHECK(a.images == b.images);
  }
}

TEST_CASE("a level belongs to the scenes that take one") {
  CHECK(make_builtin("teapot:2")->meshes[0].faces.size() == 32 * 8 - 16);
  CHECK(make_builtin("sphere:2").has_value());
  for (const char* wrong : {"teapot:0", "teapot:257", "teapot:", "teapot:1.5", "teapot:x",
                            "teapot:99999999999", "cube:3", "sphere:1", "teapot:4 ", "teapot:-3"}) {
    CAPTURE(wrong);
    const Result<Scene> scene = make_builtin(wrong);
    REQUIRE_FALSE(scene.has_value());
    CHECK_FALSE(scene.error().cause.empty());
    CHECK_FALSE(scene.error().remedy.empty());
  }
}

TEST_CASE("a misspelt name is answered with the nearest one") {
  CHECK(nearest_builtin("teapto") == "teapot");
  CHECK(nearest_builtin("Teapot") == "teapot");
  CHECK(nearest_builtin("fglyph") == "f-glyph");
  CHECK(nearest_builtin("rooom") == "room");
  CHECK_FALSE(nearest_builtin("bunny").has_value());
  CHECK_FALSE(nearest_builtin(std::string(100000, 'x')).has_value());
  const Result<Scene> scene = make_builtin("teapto:4");
  REQUIRE_FALSE(scene.has_value());
  CHECK(scene.error().message() ==
        "teapto: there is no such built-in scene; did you mean 'teapot'?");
}

TEST_CASE("generated images repeat their pattern") {
  const Image<Rgba8> checks = make_checks(4, 8, {255, 255, 255}, {0, 0, 0});
  CHECK(checks.width == 32);
  CHECK(checks.at(0, 0) == Rgba8{255, 255, 255});
  CHECK(checks.at(8, 0) == Rgba8{0, 0, 0});
  CHECK(checks.at(8, 8) == Rgba8{255, 255, 255});
  CHECK(checks.at(31, 0) == Rgba8{0, 0, 0});
}

}  // namespace
}  // namespace glassbox::test
