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

// Exact but for the volume; normals are computed in double, where the coordinates of lattices up to 4096 leave no product at 0 that is none.
MeshCheck check_mesh(const PolygonMesh& mesh);

}  // namespace glassbox::views
