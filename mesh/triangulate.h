// Polygons to triangles: the form in which meshes are drawn.
//
// A face of n corners takes n - 2 consecutive numbers whether or not its triangles are kept, so
// that a triangle's number says where it stands in the file. The choices are deterministic:
//
//   triangle   kept as it is, corners in the order of the face
//   quad       cut along the diagonal that lies inside; if both do, along the shorter one; on a
//              tie from corner 0
//   n-gon      ears clipped in a fixed order, in the plane seen along the largest component of the
//              Newell normal, with exact orientation tests
//   otherwise  (the outline crosses itself) what ear clipping leaves is cut as a fan, and the face
//              is reported
//
// As long as every triangle cut off turns the same way as its outline, the triangles cover exactly what the outline
// encloses: cutting a corner off changes no winding number in total, so none can lie twice or outside.
//
// Faces and triangles without area yield no triangles but are counted.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glassbox/mesh/mesh.h>

namespace glassbox {

struct Triangle {
  std::array<std::uint32_t, 3> corners{};  // indices into Mesh::corners
  std::uint32_t face = 0;                  // index into Mesh::faces
  std::uint32_t number = 0;                // in the mesh, from 0, gaps included
  friend bool operator==(const Triangle&, const Triangle&) = default;
};

// How many numbers a face takes.
inline std::uint32_t numbers_of(const Face& face) {
  return face.count < 3 ? 0 : face.count - 2;
}

struct Triangulation {
  std::vector<Triangle> triangles;  // numbers ascend
  std::uint32_t numbered = 0;       // numbers taken: the sum of n - 2 over the faces
  // Faces without area (exactly zero Newell vector: fewer than 3 distinct corners, collinear ones, bow-ties).
  std::vector<std::uint32_t> degenerate_faces;
  std::uint32_t degenerate_triangles = 0;  // dropped from faces that are kept
  // Outlines that cross themselves (or are too intricate, see below): the end was cut as a fan.
  std::vector<std::uint32_t> fallback_faces;
};

// O(n log n) for outlines met in practice; the tests an outline may cost are limited to 2^27 + 2^10 n, after which the
// rest of it is cut as a fan.
Triangulation triangulate(const Mesh& mesh);

}  // namespace glassbox
