#include <glassbox/mesh/topology.h>

#include <algorithm>

#include "tests/mesh/polygons.h"
#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

using Points = std::vector<Point<Object>>;

Points any_positions(int count) {
  Points points;
  for (int i = 0; i < count; ++i) points.emplace_back(float(i), float(i * i), float(i * i * i));
  return points;
}

// A grid of quads that closes in both directions.
Mesh make_torus(std::uint32_t rows, std::uint32_t columns) {
  std::vector<Indices> faces;
  for (std::uint32_t r = 0; r < rows; ++r) {
    for (std::uint32_t c = 0; c < columns; ++c) {
      const std::uint32_t down = (r + 1) % rows, right = (c + 1) % columns;
      faces.push_back(
          {r * columns + c, r * columns + right, down * columns + right, down * columns + c});
    }
  }
  return make_mesh(any_positions(int(rows * columns)), faces);
}

const std::vector<Indices> kTetrahedron = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

// The faces of a mesh, each with its own positions.
Mesh split_apart(const Mesh& mesh) {
  Mesh result;
  for (const Face& face : mesh.faces) {
    Indices own;
    for (std::uint32_t i = 0; i < face.count; ++i) {
      own.push_back(std::uint32_t(result.positions.size()));
      result.positions.push_back(mesh.positions[mesh.corners[face.first + i].position]);
    }
    add_polygon(result, own);
  }
  return result;
}

const Edge* find_edge(const Topology& topology, std::uint32_t low, std::uint32_t high) {
  for (const Edge& edge : topology.edges) {
    if (edge.low == low && edge.high == high) return &edge;
  }
  return nullptr;
}

TEST_CASE("adjacency of the five-vertex strip follows from its face table (S4-17)") {
  // F1 = (V1, V2, V3), F2 = (V3, V2, V4), F3 = (V3, V4, V5); the indices here start at 0.
  const Mesh strip = make_mesh(any_positions(5), {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}});
  const Topology t = find_topology(strip);
  CHECK(t.vertices == 5);
  CHECK(t.edges.size() == 7);
  CHECK(t.boundary_edges == 5);
  CHECK(t.inconsistent_edges == 0);
  CHECK(t.components == 1);
  CHECK(t.euler_characteristic() == 1);  // a disc
  CHECK_FALSE(t.closed());
  CHECK_FALSE(t.genus().has_value());

  // F1 and F2 pass the edge V2 V3 in opposite directions; so do F2 and F3 with V3 V4.
  for (const auto& [low, high, first, second] :
       {std::array<std::uint32_t, 4>{1, 2, 0, 1}, std::array<std::uint32_t, 4>{2, 3, 1, 2}}) {
    const Edge* edge = find_edge(t, low, high);
    REQUIRE(edge != nullptr);
    REQUIRE(edge->count == 2);
    const EdgeUse &a = t.uses[edge->first], &b = t.uses[edge->first + 1];
    CHECK(a.face == first);
    CHECK(b.face == second);
    CHECK(a.ascending != b.ascending);
  }
}

TEST_CASE("a face wound the wrong way shows at each of its inner edges") {
  const Mesh strip = make_mesh(any_positions(5), {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}});
  CHECK(find_topology(strip).inconsistent_edges == 2);
  std::vector<Indices> faces = kTetrahedron;
  std::reverse(faces[2].begin(), faces[2].end());
  const Topology t = find_topology(make_mesh(any_positions(4), faces));
  CHECK(t.inconsistent_edges == 3);
  CHECK(t.closed());
  CHECK_FALSE(t.genus().has_value());  // the genus of an unoriented surface is not defined here
}

TEST_CASE("V - E + F counts the handles of closed surfaces (S3-01)") {
  const Topology ball = find_topology(make_mesh(any_positions(4), kTetrahedron));
  CHECK(ball.closed());
  CHECK(ball.euler_characteristic() == 2);
  CHECK(ball.genus() == 0u);

  const Topology ring = find_topology(make_torus(4, 5));
  CHECK(ring.closed());
  CHECK(ring.euler_characteristic() == 0);
  CHECK(ring.genus() == 1u);

  // Two separate balls.
  std::vector<Indices> two = kTetrahedron;
  for (const Indices& f : kTetrahedron) two.push_back({f[0] + 4, f[1] + 4, f[2] + 4});
  const Topology pair = find_topology(make_mesh(any_positions(8), two));
  CHECK(pair.components == 2);
  CHECK(pair.euler_characteristic() == 4);
  CHECK(pair.genus() == 0u);
}

TEST_CASE("a closed surface with one face missing is open along that face") {
  const std::vector<Indices> three(kTetrahedron.begin(), kTetrahedron.end() - 1);
  const Topology t = find_topology(make_mesh(any_positions(4), three));
  CHECK_FALSE(t.closed());
  CHECK(t.boundary_edges == 3);
}

TEST_CASE("three faces at an edge are no surface") {
  const Topology t = find_topology(make_mesh(any_positions(5), {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}));
  CHECK(t.non_manifold_edges == 1);
  CHECK(t.boundary_edges == 6);
  CHECK_FALSE(t.closed());
}

TEST_CASE("surfaces that touch in a vertex are pinched there") {
  const Topology bow = find_topology(make_mesh(any_positions(5), {{0, 1, 2}, {2, 3, 4}}));
  CHECK(bow.pinched_vertices == 1);
  CHECK(bow.components == 2);

  // Two tetrahedra that share vertex 3: every edge is manifold, the vertex is not.
  std::vector<Indices> two = kTetrahedron;
  for (const Indices& f : kTetrahedron) {
    Indices moved;
    for (const std::uint32_t v : f) moved.push_back(v == 3 ? 3 : v + 4);
    two.push_back(moved);
  }
  const Topology t = find_topology(make_mesh(any_positions(7), two));
  CHECK(t.closed());
  CHECK(t.pinched_vertices == 1);
  CHECK_FALSE(t.genus().has_value());
}

TEST_CASE("faces that repeat their positions meet where the positions are welded") {
  const Mesh apart = split_apart(make_torus(3, 4));
  CHECK(find_topology(apart, Weld::kByIndex).boundary_edges == 48);
  const Topology welded = find_topology(apart, Weld::kByCoordinates);
  CHECK(welded.closed());
  CHECK(welded.vertices == 12);
  CHECK(welded.genus() == 1u);
  // 0 and -0 are the same place.
  const Mesh zeros =
      make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0f, -0.0f, 0}, {1, -0.0f, 0}, {0, 0, 1}},
                {{0, 1, 2}, {4, 3, 5}});
  CHECK(find_topology(zeros, Weld::kByCoordinates).boundary_edges == 4);
}

TEST_CASE("repeated corners count once and faces without three vertices take no part (C-25)") {
  const Mesh mesh =
      make_mesh(any_positions(4), {{0, 0, 1, 2, 2}, {0, 1}, {0, 1, 0, 1}, {3, 3, 3}, {}});
  const Topology t = find_topology(mesh);
  CHECK(t.faces == 1);
  CHECK(t.edges.size() == 3);
  CHECK(t.boundary_edges == 3);
  CHECK(t.euler_characteristic() == 1);
}

TEST_CASE("positions that nothing names are counted") {
  Mesh mesh = make_mesh(any_positions(8), {{0, 1, 2}});
  CHECK(find_topology(mesh).unused_positions == 5);
  mesh.lines.push_back({Corner{3}, Corner{4}});
  mesh.points.push_back(Corner{5});
  CHECK(find_topology(mesh).unused_positions == 2);
  CHECK(find_topology(Mesh()).euler_characteristic() == 0);
  CHECK_FALSE(find_topology(Mesh()).closed());
}

}  // namespace
}  // namespace glassbox::test
