// The triangles of a cell, chosen by which of its corners are inside: 256 cases (S1-39), made from
// a rule for its faces.
//
// A face whose corners are in, out, in, out is ambiguous: either its two inside corners are cut off
// one by one, or its two outside ones. Two cells that share the face have to agree. They do if the
// rule depends only on the face; then every edge of the surface has two triangles.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "views/polygons/cube.h"

namespace glassbox::views {

// A triangle's corner is given by the number of the cell's edge that it is on, or by kCellMiddle if
// it is inside the cell.
inline constexpr int kCellMiddle = 12;
using CellTriangle = std::array<std::uint8_t, 3>;

// The triangles of one cell, counter-clockwise seen from outside of the surface. A triangle's side
// is on a face of the cell only if it belongs to the surface's border there, which the neighbouring
// cell has as well. So an edge in the interior of a cell is never an edge of its neighbour.
struct CellSurface {
  std::vector<CellTriangle> triangles;
};

// `inside` has a bit for each corner. `joined` has a bit for each face: if the face is ambiguous,
// its inside corners are joined, and the outside ones are cut off one by one. 0: no face is joined.
CellSurface cell_surface(unsigned inside, unsigned joined = 0);

// The surface for every set of inside corners.
using CellTable = std::array<CellSurface, 256>;

// Inside corners are cut off one by one on every ambiguous face, so that two cells agree about the
// face that they share. No case needs a corner in the middle.
const CellTable& consistent_table();

// The fifteen cases of Lorensen and Cline (1987): a cell with more than four inside corners has the
// triangles of the cell with inside and outside exchanged, with reversed winding, and therefore the
// opposite rule on its faces. For teaching only: next to a cell with few inside corners this leaves
// a hole (C-95).
const CellTable& naive_table();

// The ambiguous faces of a cell, one bit each.
unsigned ambiguous_faces(unsigned inside);

}  // namespace glassbox::views
