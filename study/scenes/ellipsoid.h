// Makes an ellipsoid of any number of triangles.
#pragma once

#include <cstdint>

#include <glassbox/mesh/mesh.h>

namespace glassbox::study {

struct EllipsoidGrid {
  int stacks = 2;  // number from pole to pole, at least 2
  int slices = 3;  // number around the axis, at least 3
  // The quads are listed in bands of this many columns; 0: row by row, from the north pole down.
  int band = 0;
};

inline std::uint64_t triangles_of(const EllipsoidGrid& grid) {
  return 2 * std::uint64_t(grid.slices) * std::uint64_t(grid.stacks - 1);
}

// Semi-axes (1.7, 1, 1), poles on the y axis, counter-clockwise seen from outside. Each corner has
// the same index for its position and its normal. Trigonometry is computed in double and stored as
// float.
Mesh make_ellipsoid(const EllipsoidGrid& grid);

}  // namespace glassbox::study
