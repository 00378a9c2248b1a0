#include <glassbox/mesh/check.h>

#include <glassbox/mesh/bounding_box.h>

#include "tests/mesh/polygons.h"
#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

using Points = std::vector<Point<Object>>;

const Points kCubeCorners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                             {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
const std::vector<Indices> kCubeFaces = {{0, 4, 6, 2}, {5, 1, 3, 7}, {0, 1, 5, 4},
                                         {6, 7, 3, 2}, {1, 0, 2, 3}, {4, 5, 7, 6}};

TEST_CASE("nothing is wrong with a cube") {
  const MeshReport report = mesh_report(make_mesh(kCubeCorners, kCubeFaces));
  CHECK(report.clean());
  CHECK(report.closed);
  CHECK(report.genus == 0u);
  CHECK(report.vertices == 8);
  CHECK(report.edges == 12);
  CHECK(report.faces == 6);
  CHECK(report.triangles == 12);
  CHECK(report.euler_characteristic == 2);
  CHECK(report.area == 6);
  CHECK(report.bounds.low == Point<Object, double>(0, 0, 0));
  CHECK(report.bounds.high == Point<Object, double>(1, 1, 1));
}

TEST_CASE("each fault that is planted in a cube is reported, and only it") {
  SECTION("an open side") {
    const std::vector<Indices> five(kCubeFaces.begin(), kCubeFaces.end() - 1);
    const MeshReport report = mesh_report(make_mesh(kCubeCorners, five));
    CHECK(report.open_edges == 4);
    CHECK_FALSE(report.closed);
    CHECK(report.clean());
  }
  SECTION("a side wound the wrong way") {
    std::vector<Indices> faces = kCubeFaces;
    faces[3] = Indices(faces[3].rbegin(), faces[3].rend());
    const MeshReport report = mesh_report(make_mesh(kCubeCorners, faces));
    CHECK(report.inconsistent_edges == 4);
    CHECK(report.open_edges == 0);
    CHECK_FALSE(report.clean());
  }
  SECTION("a side twice, from another corner and the other way round") {
    std::vector<Indices> faces = kCubeFaces;
    faces.push_back({3, 7, 5, 1});
    faces.push_back({1, 5, 7, 3});
    faces.push_back({1, 7, 5, 3});  // the same vertices, but another outline
    const MeshReport report = mesh_report(make_mesh(kCubeCorners, faces));
    CHECK(report.duplicate_faces == 2);
    CHECK(report.non_manifold_edges > 0);
  }
  SECTION("a bent side") {
    Points points = kCubeCorners;
    points[7] = {1, 1, 1.25f};
    const MeshReport report = mesh_report(make_mesh(points, kCubeFaces));
    // The corner moves within the planes of the two other faces that it belongs to.
    CHECK(report.non_planar_faces == 1);
    CHECK(report.worst_planarity_face == 5);
    CHECK(report.worst_planarity_deviation > 0.05);
    CHECK(report.worst_planarity_deviation < 0.25 / 4);
  }
  SECTION("faces without area, and positions that nothing uses") {
    std::vector<Indices> faces = kCubeFaces;
    faces.push_back({0, 0, 1});
    Points points = kCubeCorners;
    points.emplace_back(9.0f, 9.0f, 9.0f);
    const MeshReport report = mesh_report(make_mesh(points, faces));
    CHECK(report.degenerate_faces == 1);
    CHECK(report.unused_positions == 1);
    CHECK(report.euler_characteristic == 2);
    // Positions that are not drawn do not count.
    CHECK(report.bounds.high == Point<Object, double>(1, 1, 1));
    CHECK_FALSE(report.clean());
  }
  SECTION("an outline that crosses itself") {
    Points points = kCubeCorners;
    points.insert(points.end(), {{5, 0, 0}, {7, 2, 0}, {7, 0, 0}, {5, 1, 0}});
    std::vector<Indices> faces = kCubeFaces;
    faces.push_back({8, 9, 10, 11});
    CHECK(mesh_report(make_mesh(points, faces)).self_intersecting_faces == 1);
  }
}

TEST_CASE("quads in Z order are told from other faces that are not drawn") {
  // The corners of a square row by row, and those of a quad without equal sides.
  const Points points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {3, 3, 0}, {2, 0, 0}};
  const auto in_z_order = [&](const Indices& face) {
    return mesh_report(make_mesh(points, {face})).quads_in_z_order;
  };
  CHECK(in_z_order({0, 1, 2, 3}) == 1);
  CHECK(in_z_order({1, 3, 0, 2}) == 1);
  CHECK(in_z_order({0, 1, 2, 4}) == 1);  // with an area: it is called crossing itself
  CHECK(in_z_order({0, 1, 3, 2}) == 0);
  CHECK(in_z_order({0, 3, 1, 2}) == 0);  // a bow-tie of another order
  CHECK(in_z_order({0, 1, 5, 1}) == 0);
  CHECK(in_z_order({0, 1, 5}) == 0);
  const MeshReport report = mesh_report(make_mesh(points, {{0, 1, 2, 3}, {2, 3, 0, 1}, {0, 1, 5}}));
  CHECK(report.degenerate_faces == 3);
  CHECK(report.quads_in_z_order == 2);
}

TEST_CASE("flat faces stay flat when their corners are rounded to floats") {
  // A tilted hexagon far from the origin: its corners are up to half an ulp off the plane.
  Points points;
  for (const auto& [x, y] :
       {std::array{2.0, 0.0}, std::array{1.0, 1.7}, std::array{-1.0, 1.7}, std::array{-2.0, 0.0},
        std::array{-1.0, -1.7}, std::array{1.0, -1.7}}) {
    points.emplace_back(float(1000 + x), float(1000 + 0.8 * y), float(1000 + 0.6 * y + x / 3));
  }
  CHECK(mesh_report(make_polygon(points)).non_planar_faces == 0);
}

TEST_CASE("the box of a turned object is the box of its turned positions") {
  Mesh line;
  line.positions = {{0, 0, 0}, {1, 1, 0}, {100, 100, 100}};
  line.lines.push_back({Corner{0}, Corner{1}});
  Scene scene;
  scene.meshes.push_back(line);
  Node quarter_turn;  // x becomes y, y becomes -x; then a translation by 10 along x
  quarter_turn.world_from_node.at(0, 0) = 0;
  quarter_turn.world_from_node.at(0, 1) = -1;
  quarter_turn.world_from_node.at(0, 3) = 10;
  quarter_turn.world_from_node.at(1, 0) = 1;
  quarter_turn.world_from_node.at(1, 1) = 0;
  scene.nodes.push_back(quarter_turn);
  CHECK(bounds(scene).empty());
  scene.instances.push_back({0, 0});
  CHECK(bounds(scene).low == Point<World, double>(9, 0, 0));
  CHECK(bounds(scene).high == Point<World, double>(10, 1, 0));

  // Turned by 45 degrees, the line is upright and has no width, while the turned corners of its box
  // would give it some.
  const double half = 0.7071067811865476;
  Node eighth;
  eighth.world_from_node.at(0, 0) = half;
  eighth.world_from_node.at(0, 1) = -half;
  eighth.world_from_node.at(1, 0) = half;
  eighth.world_from_node.at(1, 1) = half;
  scene.nodes[0] = eighth;
  CHECK(bounds(scene).high.x == 0);
}

}  // namespace
}  // namespace glassbox::test
