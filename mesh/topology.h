// Adjacency: which faces, edges and vertices are neighbours. It is derived from the face table,
// which by itself holds "still no topology information" (S4-17).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <glassbox/mesh/mesh.h>

namespace glassbox {

// kByIndex: corners meet where they have the same position index. kByCoordinates: also where two
// positions have the same coordinates (0 and -0 are equal), as in glTF, which repeats a position
// for each of its normals or texture coordinates.
enum class Weld { kByIndex, kByCoordinates };

// One face's use of an edge: the face's outline passes along the edge.
struct EdgeUse {
  std::uint32_t face = 0;
  std::uint32_t corner = 0;  // into Mesh::corners: the corner at which the passage starts
  bool ascending = true;     // from the edge's `low` vertex to its `high` one
  friend bool operator==(const EdgeUse&, const EdgeUse&) = default;
};

// An edge between two vertices. The faces that use it are uses[first] .. uses[first + count - 1].
struct Edge {
  std::uint32_t low = 0, high = 0;  // vertices, low < high
  std::uint32_t first = 0, count = 0;

  bool boundary() const { return count == 1; }
  bool non_manifold() const { return count > 2; }
  friend bool operator==(const Edge&, const Edge&) = default;
};

// A vertex is a position after welding, identified by the lowest index of its positions. If a face
// has the same vertex several times in a row, it counts once; faces with fewer than three distinct
// vertices have no edges and are ignored.
struct Topology {
  std::vector<std::uint32_t> vertex_of_position;
  std::vector<Edge> edges;    // sorted by (low, high)
  std::vector<EdgeUse> uses;  // edge by edge, in the order of the faces

  std::uint32_t vertices = 0;            // the vertices of the faces that are not ignored
  std::uint32_t faces = 0;               // the faces that are not ignored
  std::uint32_t boundary_edges = 0;      // edges of one face only
  std::uint32_t non_manifold_edges = 0;  // edges of more than two faces
  // Edges along which two faces pass in the same direction: the two faces have opposite windings.
  std::uint32_t inconsistent_edges = 0;
  // Vertices whose faces do not form a single fan (closed, or open at a boundary): surfaces that
  // touch in a point.
  std::uint32_t pinched_vertices = 0;
  std::uint32_t unused_positions = 0;  // used by no face, line or point
  std::uint32_t components = 0;        // sets of faces connected across edges

  // Whether every edge is used by exactly two faces, and there is at least one face.
  bool closed() const { return faces > 0 && boundary_edges == 0 && non_manifold_edges == 0; }
  // V - E + F for V vertices, E edges and F faces.
  std::int64_t euler_characteristic() const {
    return std::int64_t(vertices) - std::int64_t(edges.size()) + std::int64_t(faces);
  }
  // The number of handles of all components together, from V - E + F = 2 (components - genus)
  // (S3-01). Absent unless the mesh is a closed surface, wound consistently and without pinched
  // vertices.
  std::optional<std::uint32_t> genus() const;
};

// Takes O(n log n) in the number of corners.
Topology find_topology(const Mesh& mesh, Weld weld = Weld::kByIndex);

}  // namespace glassbox
