// Divides polygons into triangles, the form in which meshes are drawn.
//
// A face of n corners takes n - 2 consecutive numbers whether or not its triangles are kept, so
// that a triangle's number gives its place in the file. The choices are deterministic:
//
//   triangle   kept as it is, corners in the order of the face
//   quad       cut along the diagonal that is inside; if both are, along the shorter one; on a
//              tie from corner 0
//   n-gon      ears clipped in a fixed order, in the plane seen along the largest component of
//              the Newell normal, with exact orientation tests
//   touching   an n-gon that repeats a corner, or whose edges touch or lie on each other, is first
//              divided into the parts of its inside by even-odd (mesh/even_odd.h)
//   otherwise  (the outline crosses itself) the rest after ear clipping is cut as a fan, and
//              the face is reported
//
// If every triangle that is cut off has the same winding as its outline, the triangles cover
// exactly the inside of an outline that does not cross itself: at every point the winding numbers
// of the triangles and of the outline that is left add up to that of the original outline, so no
// triangle can cover a place twice or be outside.
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
  std::uint32_t number = 0;                // in the mesh, from 0; dropped triangles are counted too
  friend bool operator==(const Triangle&, const Triangle&) = default;
};

// The number of triangle numbers that a face takes.
inline std::uint32_t triangle_number_count(const Face& face) {
  return face.count < 3 ? 0 : face.count - 2;
}

struct Triangulation {
  std::vector<Triangle> triangles;  // in the order of their numbers
  std::uint32_t numbered = 0;       // count of numbers taken: the sum of n - 2 over the faces
  // Faces without area (exactly zero Newell vector: fewer than 3 distinct corners, collinear ones,
  // bow-ties; and outlines that are walked twice, which enclose nothing by even-odd).
  std::vector<std::uint32_t> degenerate_faces;
  std::uint32_t degenerate_triangles = 0;  // dropped from faces that are kept
  // Faces whose outlines cross themselves (or are too complicated, see below): the rest was cut as
  // a fan.
  std::vector<std::uint32_t> fallback_faces;
};

// Takes O(n log n) for outlines that occur in practice. The tests for one outline are limited to
// 2^27 + 2^10 n, after which the rest of it is cut as a fan.
Triangulation triangulate(const Mesh& mesh);

}  // namespace glassbox
