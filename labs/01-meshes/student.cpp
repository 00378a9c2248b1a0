// Lab 1: your part. student.h says what each function must do, handout.md why.
#include "student.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace lab_01 {

// ---- task 1.1: the tables ----

Mesh read_mesh(const std::string& text) {
  // BEGIN SOLUTION
  Mesh mesh;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string kind;
    words >> kind;
    if (kind == "v") {
      Point<Object> p;
      if (!(words >> p.x >> p.y >> p.z)) throw std::invalid_argument("not three numbers: " + line);
      mesh.positions.push_back(p);
    } else if (kind == "f") {
      glassbox::Face face{std::uint32_t(mesh.corners.size()), 0};
      const long count = long(mesh.positions.size());
      for (long number = 0; words >> number; ++face.count) {
        const long index = number < 0 ? count + number : number - 1;
        if (index < 0 || index >= count) throw std::invalid_argument("no such position: " + line);
        glassbox::Corner corner;
        corner.position = std::uint32_t(index);
        mesh.corners.push_back(corner);
      }
      if (face.count < 3) throw std::invalid_argument("fewer than three corners: " + line);
      mesh.faces.push_back(face);
    }
  }
  return mesh;
  // STUB: return {};  // the tables that the text describes
  // END SOLUTION
}

// ---- task 1.2: who is next to whom ----

// BEGIN SOLUTION
// The positions of a face, without each position that the next corner repeats; empty if fewer than
// three are different.
static std::vector<std::uint32_t> ring_of(const Mesh& mesh, const glassbox::Face& face) {
  std::vector<std::uint32_t> ring;
  for (std::uint32_t c = face.first; c < face.first + face.count; ++c) {
    const std::uint32_t position = mesh.corners[c].position;
    if (ring.empty() || ring.back() != position) ring.push_back(position);
  }
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  if (std::set<std::uint32_t>(ring.begin(), ring.end()).size() < 3) ring.clear();
  return ring;
}
// STUB:
// END SOLUTION

EdgeTable find_edges(const Mesh& mesh) {
  // BEGIN SOLUTION
  std::map<std::pair<std::uint32_t, std::uint32_t>, Edge> edges;
  std::set<std::uint32_t> vertices;
  int faces = 0;
  for (const glassbox::Face& face : mesh.faces) {
    const std::vector<std::uint32_t> ring = ring_of(mesh, face);
    faces += ring.empty() ? 0 : 1;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::uint32_t from = ring[i], to = ring[(i + 1) % ring.size()];
      Edge& edge = edges[std::minmax(from, to)];
      edge.low = std::min(from, to);
      edge.high = std::max(from, to);
      ++(from < to ? edge.ascending : edge.descending);
      vertices.insert(from);
    }
  }
  EdgeTable table;
  table.closed = faces > 0;
  for (const auto& [ends, edge] : edges) {
    table.edges.push_back(edge);
    table.closed = table.closed && edge.ascending + edge.descending == 2;
  }
  table.euler = int(vertices.size()) - int(edges.size()) + faces;
  return table;
  // STUB: return {{}, 1000, false};  // the edges, V - E + F, and whether every edge has two faces
  // END SOLUTION
}

// ---- task 1.3: the same way round ----

std::optional<std::vector<int>> faces_to_turn(const Mesh& mesh) {
  // BEGIN SOLUTION
  // For each edge, the faces that pass along it, and in which direction.
  struct Passage {
    std::size_t face;
    bool ascending;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Passage>> passages;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const glassbox::Face& face = mesh.faces[f];
    for (std::uint32_t i = 0; i < face.count; ++i) {
      const std::uint32_t from = mesh.corners[face.first + i].position;
      const std::uint32_t to = mesh.corners[face.first + (i + 1) % face.count].position;
      passages[std::minmax(from, to)].push_back({f, from < to});
    }
  }
  std::vector<std::vector<std::pair<std::size_t, int>>> neighbours(mesh.faces.size());
  for (const auto& [ends, both] : passages) {
    if (both.size() != 2) continue;
    const int differ = both[0].ascending == both[1].ascending ? 1 : 0;
    neighbours[both[0].face].push_back({both[1].face, differ});
    neighbours[both[1].face].push_back({both[0].face, differ});
  }
  constexpr int kUnknown = -1;
  std::vector<int> turn(mesh.faces.size(), kUnknown);
  for (std::size_t first = 0; first < turn.size(); ++first) {
    if (turn[first] != kUnknown) continue;
    turn[first] = 0;
    std::vector<std::size_t> open{first};
    while (!open.empty()) {
      const std::size_t face = open.back();
      open.pop_back();
      for (const auto& [other, differ] : neighbours[face]) {
        const int wanted = turn[face] ^ differ;
        if (turn[other] == kUnknown) {
          turn[other] = wanted;
          open.push_back(other);
        } else if (turn[other] != wanted) {
          return std::nullopt;
        }
      }
    }
  }
  return turn;
  // STUB: return std::vector<int>{};  // 1 where a face must be turned, else 0; or std::nullopt
  // END SOLUTION
}

// ---- task 1.4: the normal of any polygon ----

Vector<Object> newell_vector(const std::vector<Point<Object>>& polygon) {
  // BEGIN SOLUTION
  const Point<Object> origin = polygon.front();
  Vector<Object> m(0, 0, 0);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector<Object> p = polygon[i] - origin;
    const Vector<Object> next = polygon[(i + 1) % polygon.size()] - origin;
    m.x += (p.y - next.y) * (p.z + next.z);
    m.y += (p.z - next.z) * (p.x + next.x);
    m.z += (p.x - next.x) * (p.y + next.y);
  }
  return m;
  // STUB: return {NAN, NAN, NAN};  // twice the area, along the normal
  // END SOLUTION
}

// ---- task 1.5: an angle that keeps its digits ----

double angle_between(const Vector<Object, double>& a, const Vector<Object, double>& b) {
  // BEGIN SOLUTION
  const Vector<Object, double> across = cross(a, b);
  return std::atan2(std::sqrt(dot(across, across)), dot(a, b));
  // STUB: return NAN;  // radians
  // END SOLUTION
}

}  // namespace lab_01
