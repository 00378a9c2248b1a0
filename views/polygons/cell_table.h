// Which triangles a cell has, by which of its corners are inside: 256 cases (S1-39), made from a rule for its faces.
//
// A face whose corners are in, out, in, out is ambiguous: it shows either two inside corners that are cut off one by one, or two outside
// ones. Two cells that share the face have to agree. Where the rule looks at the face alone they do, and every edge of the surface has
// two triangles.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "views/polygons/cube.h"

namespace glassbox::views {

// Corners of the surface are numbered by the edge of the cell that they lie on; kCellMiddle lies inside the cell.
inline constexpr int kCellMiddle = 12;
using CellTriangle = std::array<std::uint8_t, 3>;

// The triangles of one cell, counter-clockwise seen from outside of the surface. No side of one runs across a face of the cell but
// along its own border, which the cell beside has as well: what is inside a cell is never an edge of the cell beside it.
struct CellSurface {
  std::vector<CellTriangle> triangles;
};

// `inside`: a bit for each corner. `joined`: a bit for each face on which, if it is ambiguous, the inside corners are joined, so that
// the outside ones are cut off one by one; 0: on none.
CellSurface cell_surface(unsigned inside, unsigned joined = 0);

// Of every set of corners.
using CellTable = std::array<CellSurface, 256>;

// Inside corners are cut off one by one on every ambiguous face: two cells agree about the face that they share. No case needs a middle.
const CellTable& consistent_table();

// The fifteen cases of Lorensen and Cline (1987): cells with more than four corners inside have the triangles of the opposite case,
// turned round, and thereby the opposite rule on their faces. Teaching only: beside a cell with few corners inside it leaves a hole (C-95).
const CellTable& naive_table();

// Faces of a cell, by a bit each, that are ambiguous.
unsigned ambiguous_faces(unsigned inside);

}  // namespace glassbox::views
