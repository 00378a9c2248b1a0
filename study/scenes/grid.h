// An ellipsoid of as many triangles as one likes.
#pragma once

#include <cstdint>

#include <glassbox/mesh/mesh.h>

namespace glassbox::study {

struct Grid {
  int stacks = 2;  // from pole to pole, at least 2
  int slices = 3;  // around, at least 3
  int band = 0;    // quads of a column band; 0: rows, from the north pole down
};

inline std::uint64_t triangles_of(const Grid& grid) {
  return 2 * std::uint64_t(grid.slices) * std::uint64_t(grid.stacks - 1);
}

// Semi-axes (1.7, 1, 1), poles on y, counter-clockwise seen from outside. Every corner has one index, into positions and
// normals alike. Trigonometry in double, stored as float.
Mesh make_ellipsoid(const Grid& grid);

}  // namespace glassbox::study
