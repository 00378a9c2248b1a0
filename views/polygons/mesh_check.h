// Properties of a surface of triangles: whether it is closed, how many handles it has, and the
// volume that it encloses.
#pragma once

#include <cstdint>

#include "views/polygons/polygonise.h"

namespace glassbox::views {

struct MeshCheck {
  std::int64_t edges = 0;               // sides of triangles, each counted once
  std::int64_t holes = 0;               // edges with only one triangle
  std::int64_t non_manifold_edges = 0;  // edges with more than two triangles
  // Edges with two triangles that run along them in the same direction.
  std::int64_t misoriented_edges = 0;
  // Triangles whose corners are on a line: those for which all coordinates of the normal are 0.
  std::int64_t degenerate = 0;
  std::int64_t duplicates = 0;  // corners at the same place as another one
  std::int64_t pinched = 0;     // corners around which the triangles are more than one fan
  std::int64_t corners = 0;     // corners that at least one triangle uses
  // Corners - edges + triangles: 2 for each connected closed surface, minus 2 for each handle.
  std::int64_t euler = 0;
  double volume = 0;  // enclosed by the closed surface, in cubic lattice units

  bool is_closed() const { return holes == 0 && non_manifold_edges == 0 && misoriented_edges == 0; }
};

// Everything except the volume is exact for surfaces that polygonise() makes of lattices of up to
// 4096 corners along an axis. Normals are computed in double. Coordinates are below 2^12, so the
// distance between neighbouring doubles (their step) is at most 2^-41. Differences of two corners
// of a cell are at most 1 and are whole multiples of these steps: none of them is rounded. Each
// coordinate of a normal is a difference of two products of such differences, with an error of at
// most 2^-52. The corners of a triangle are inside three edges of a cube, at least 2^-10 from the
// cube's corners: two of them are at least 2^-10 apart, and each is at least 2^-11 from the line
// through the others. So the normal, whose length is the product of such a side and height, has a
// length of at least 2^-21, and one of its coordinates is at least 2^-22: too large to be rounded
// to 0. Only a triangle with its corners on a line has the normal 0.
MeshCheck check_mesh(const PolygonMesh& mesh);

}  // namespace glassbox::views
