// S3-01, S4-16, S4-17: tables of neighbours, and Newell's sums row by row.
#include <glassbox/mesh/neighbours.h>

#include <algorithm>
#include <set>

#include <glassbox/base/random.h>
#include <glassbox/mesh/newell_sums.h>
#include <glassbox/mesh/normals.h>

#include "tests/mesh/polygons.h"
#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

using NumberSet = std::set<std::uint32_t>;

NumberSet set_of(std::span<const std::uint32_t> numbers) {
  return {numbers.begin(), numbers.end()};
}

// Faces of three to six corners among few positions, some of which have the same coordinates, so
// that corners repeat, edges have many faces, and vertices are welded.
Mesh random_mesh(Random& random) {
  Mesh mesh;
  const auto positions = std::uint32_t(random.integer(3, 12));
  for (std::uint32_t i = 0; i < positions; ++i) {
    const auto x = float(random.integer(0, 2)), y = float(random.integer(0, 2));
    mesh.positions.emplace_back(x, y, float(random.integer(0, 1)));
  }
  const std::int64_t faces = random.integer(0, 20);
  for (std::int64_t f = 0; f < faces; ++f) {
    Indices corners(std::size_t(random.integer(3, 6)));
    for (std::uint32_t& corner : corners)
      corner = std::uint32_t(random.integer(0, std::int64_t(positions) - 1));
    add_polygon(mesh, corners);
  }
  return mesh;
}

// The sides of a face as pairs of different vertices, straight from its corners; none for a face
// with fewer than three different vertices.
std::set<std::array<std::uint32_t, 2>> sides_of(const Mesh& mesh, const Topology& topology,
                                                const Face& face) {
  const auto vertex = [&](std::uint32_t i) {
    return topology.vertex_of_position[mesh.corners[face.first + i % face.count].position];
  };
  std::set<std::array<std::uint32_t, 2>> sides;
  NumberSet vertices;
  for (std::uint32_t i = 0; i < face.count; ++i) {
    const std::uint32_t a = vertex(i), b = vertex(i + 1);
    vertices.insert(a);
    if (a != b) sides.insert({std::min(a, b), std::max(a, b)});
  }
  if (vertices.size() < 3) sides.clear();
  return sides;
}

TEST_CASE("neighbours are symmetric, and those that the corners of the faces say (S4-17)") {
  Random random(40);
  for (int trial = 0; trial < 500; ++trial) {
    const Mesh mesh = random_mesh(random);
    const Weld weld = trial % 2 == 0 ? Weld::kByIndex : Weld::kByCoordinates;
    const Topology topology = find_topology(mesh, weld);
    const Neighbours neighbours = find_neighbours(mesh, topology);
    CAPTURE(trial);
    REQUIRE(neighbours.faces_of_vertex.size() == mesh.positions.size());
    REQUIRE(neighbours.edges_of_face.size() == mesh.faces.size());
    std::vector<std::set<std::array<std::uint32_t, 2>>> sides;
    for (const Face& face : mesh.faces) sides.push_back(sides_of(mesh, topology, face));
    std::vector<NumberSet> beside;
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
      std::set<std::array<std::uint32_t, 2>> listed;
      for (const std::uint32_t e : neighbours.edges_of_face[f])
        listed.insert({topology.edges[e].low, topology.edges[e].high});
      CHECK(listed == sides[f]);
      const auto list = faces_beside(topology, neighbours, f);
      CHECK(std::is_sorted(list.begin(), list.end()));
      beside.push_back(set_of(list));
      CHECK(beside.back().size() == list.size());
    }
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
      for (std::uint32_t g = 0; g < mesh.faces.size(); ++g) {
        const bool share = std::ranges::any_of(
            sides[f], [&](const auto& side) { return sides[g].contains(side); });
        CHECK(beside[f].contains(g) == (f != g && share));
        CHECK(beside[f].contains(g) == beside[g].contains(f));
      }
    }
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
      NumberSet faces, edges;
      for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
        for (const auto& [low, high] : sides[f]) {
          if (low == v || high == v) faces.insert(f);
        }
      }
      for (std::uint32_t e = 0; e < topology.edges.size(); ++e) {
        if (topology.edges[e].low == v || topology.edges[e].high == v) edges.insert(e);
      }
      CHECK(set_of(neighbours.faces_of_vertex[v]) == faces);
      CHECK(neighbours.faces_of_vertex[v].size() == faces.size());
      CHECK(set_of(neighbours.edges_of_vertex[v]) == edges);
    }
  }
}

// A closed surface: the sides of a tube of `around` quads around and `along` along, and a polygon
// at each end.
Mesh closed_tube(std::uint32_t around, std::uint32_t along) {
  Mesh mesh;
  std::vector<Point<Object>> positions;
  for (std::uint32_t i = 0; i < around * (along + 1); ++i)
    positions.emplace_back(float(i), float(i * i % 17), float(i % 5));
  std::vector<Indices> faces;
  for (std::uint32_t row = 0; row < along; ++row) {
    for (std::uint32_t i = 0; i < around; ++i) {
      const std::uint32_t right = (i + 1) % around, above = (row + 1) * around;
      faces.push_back({row * around + i, row * around + right, above + right, above + i});
    }
  }
  Indices bottom, top;
  for (std::uint32_t i = 0; i < around; ++i) {
    bottom.push_back(around - 1 - i);
    top.push_back(along * around + i);
  }
  faces.push_back(bottom);
  faces.push_back(top);
  return make_mesh(std::move(positions), faces);
}

TEST_CASE("on closed surfaces V - E + F = 2 by the tables, and each edge has two faces (S3-01)") {
  Random random(41);
  for (int trial = 0; trial < 40; ++trial) {
    const auto around = std::uint32_t(random.integer(3, 9));
    const Mesh mesh = closed_tube(around, std::uint32_t(random.integer(1, 6)));
    const Topology topology = find_topology(mesh);
    const Neighbours neighbours = find_neighbours(mesh, topology);
    CAPTURE(trial, around);
    std::int64_t vertices = 0, sides = 0, ends = 0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      vertices += !neighbours.faces_of_vertex[v].empty();
      ends += std::int64_t(neighbours.edges_of_vertex[v].size());
      // Around a vertex of a closed surface there are as many edges as faces.
      CHECK(neighbours.edges_of_vertex[v].size() == neighbours.faces_of_vertex[v].size());
    }
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
      sides += std::int64_t(neighbours.edges_of_face[f].size());
    const auto edges = std::int64_t(topology.edges.size());
    CHECK(vertices - edges + std::int64_t(mesh.faces.size()) == 2);
    CHECK(sides == 2 * edges);
    CHECK(ends == 2 * edges);
  }
}

TEST_CASE("the five-vertex strip's neighbours are those of the slide (S4-17)") {
  const Mesh strip = make_mesh({{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {2, 0, 0}},
                               {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}});
  const Topology topology = find_topology(strip);
  const Neighbours neighbours = find_neighbours(strip, topology);
  CHECK(set_of(neighbours.faces_of_vertex[2]) == NumberSet{0, 1, 2});
  CHECK(set_of(neighbours.faces_of_vertex[4]) == NumberSet{2});
  CHECK(faces_beside(topology, neighbours, 1) == Indices{0, 2});
  CHECK(faces_beside(topology, neighbours, 0) == Indices{1});
}

TEST_CASE("each row of Newell's sums is that of rationals, within its bound (S4-16, C-22)") {
  Random random(42);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Point<Object>> points(std::size_t(random.integer(3, 12)));
    const double size = random.scaled(0.5, 1, -10, 10), offset = random.scaled(-1, 1, -10, 20);
    for (auto& p : points) {
      const double x = random.between(-size, size), y = random.between(-size, size);
      const double z = random.between(-size, size);
      p = {float(offset + x), float(offset + y), float(z)};
    }
    const Mesh mesh = make_polygon(points);
    const std::vector<NewellRow> rows = newell_rows(mesh, mesh.faces[0]);
    const Vector<Object, double> bound = newell_error_bound(rows);
    CAPTURE(trial, size, offset);
    REQUIRE(rows.size() == points.size());
    ExactVector sums(0, 0, 0);
    const auto within = [](const Rational& exact, double found, double allowed) {
      return abs(exact - Rational(found)) <= Rational(allowed);
    };
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const ExactPoint a = exact(points[i]), b = exact(points[(i + 1) % points.size()]);
      const ExactVector terms((a.y - b.y) * (a.z + b.z), (a.z - b.z) * (a.x + b.x),
                              (a.x - b.x) * (a.y + b.y));
      sums = sums + terms;
      CHECK(within(terms.x, rows[i].terms.x, 3.01 * 0x1p-53 * std::abs(rows[i].terms.x)));
      CHECK(within(terms.y, rows[i].terms.y, 3.01 * 0x1p-53 * std::abs(rows[i].terms.y)));
      CHECK(within(terms.z, rows[i].terms.z, 3.01 * 0x1p-53 * std::abs(rows[i].terms.z)));
      CHECK(within(sums.x, rows[i].sums.x, bound.x));
      CHECK(within(sums.y, rows[i].sums.y, bound.y));
      CHECK(within(sums.z, rows[i].sums.z, bound.z));
    }
    // From the first corner the exact result is the same.
    const std::vector<ExactPoint> corners = exact(points);
    CHECK(sums == newell_vector<Rational>(std::span<const ExactPoint>(corners)));
  }
}

}  // namespace
}  // namespace glassbox::test
