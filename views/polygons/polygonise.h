// Finds the surface around the inside of a field: marching cubes (Lorensen and Cline, SIGGRAPH
// 1987; S1-39) and alternatives.
//
// A value equal to the level is inside, as if it were larger by an infinitely small amount (C-96).
// The surface's corners are on edges of the lattice between an inside and an outside end, at least
// kMinStep of the edge away from both. So each is in the interior of its own edge, and no two are
// at the same place. Three points in the interiors of three edges of a cube are never on one line
// (the middle one would be between two points of the cube that are not on its edge), so no triangle
// is degenerate.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "views/polygons/cell_table.h"
#include "views/polygons/scalar_field.h"
#include "views/two_view/camera.h"

namespace glassbox::views {

enum class Polygoniser {
  kConsistent,  // the table of 256 cases with one rule for all ambiguous faces
  kNaive,       // the table of fifteen cases, which leaves holes
  // Ambiguous faces are decided by the bilinear function on them (Nielson and Hamann 1991).
  kSaddle,
  kTetrahedra,  // six tetrahedra around the diagonal of each cell
};
std::string_view name_of(Polygoniser polygoniser);

inline constexpr double kMinStep = 0x1p-10;  // as a fraction of an edge

using PolygonCorners = std::array<std::uint32_t, 3>;

struct PolygonMesh {
  std::vector<Vector3d> positions;       // lattice coordinates: corner (x, y, z) is at (x, y, z)
  std::vector<PolygonCorners> polygons;  // counter-clockwise seen from outside
};

// The surface is closed: everything outside of the lattice counts as outside, and the surface is
// half an edge beyond the last corners. Values have to be finite. The memory is proportional to one
// layer of the lattice, plus the result.
PolygonMesh polygonise(const ScalarField& field, double level, Polygoniser polygoniser);

// polygonise() with any table, to try out other tables.
PolygonMesh polygonise_with(const CellTable& table, const ScalarField& field, double level);

// The position of the surface on an edge, as a fraction of the edge from the end with the value
// `from`. One of the two values is at least the level, the other is below it.
double crossing(double from, double to, double level);

}  // namespace glassbox::views
