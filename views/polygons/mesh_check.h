// What a surface made of triangles is: closed or not, how many handles, how much it encloses.
#pragma once

#include <cstdint>

#include "views/polygons/polygonise.h"

namespace glassbox::views {

struct MeshCheck {
  std::int64_t edges = 0;    // sides of triangles, each counted once
  std::int64_t holes = 0;    // edges of one triangle
  std::int64_t crowded = 0;  // edges of more than two
  std::int64_t turned = 0;   // edges of two that run along them in the same direction
  std::int64_t degenerate =
      0;  // triangles whose corners are on a line: those of which no coordinate of the normal is other than 0
  std::int64_t duplicates = 0;  // corners at the place of another one
  std::int64_t pinched = 0;     // corners around which the triangles are more than one fan
  std::int64_t corners = 0;     // that a triangle has
  std::int64_t euler =
      0;  // corners - edges + triangles: 2 for each closed piece, less 2 for each handle
  double volume = 0;  // of the closed, cubic lattice units

  bool is_closed() const { return holes == 0 && crowded == 0 && turned == 0; }
};

// Exact but for the volume, of surfaces that polygonise() makes of lattices of up to 4096 corners along an axis: normals are computed in double.
// Coordinates are below 2^12, so their steps are at most 2^-41, and differences of two corners of a cell, which are at most 1, are whole
// numbers of these: none is rounded. Each coordinate of a normal is a difference of two products of them and off by at most 2^-52. The corners lie
// inside three edges of a cube, 2^-10 from its corners: two of them are at least 2^-10 apart, each at least 2^-11 from the line through the others, so
// the normal is at least 2^-21 long, and one of its coordinates 2^-22: far from being rounded to 0. Only a triangle on a line has none.
MeshCheck check_mesh(const PolygonMesh& mesh);

}  // namespace glassbox::views
