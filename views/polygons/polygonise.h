// A surface around what is inside of a field: marching cubes (Lorensen and Cline, SIGGRAPH 1987; S1-39) and its competitors.
//
// A value that equals the level is inside, as if it were larger by an infinitely small amount (C-96). The surface's corners lie
// on edges of the lattice between an inside and an outside end, and keep kLeastStep of the edge away from both: so each lies in the
// interior of an edge of its own, no two are in one place, and as three points in the interiors of three edges of a cube never lie on
// one line (the middle one would be between two points of the cube that are not on its edge), no triangle is degenerate.
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
  kConsistent,  // the table of 256 cases with one rule for faces
  kNaive,       // the table of fifteen cases, which leaves holes
  kSaddle,      // ambiguous faces as the bilinear function on them has it (Nielson and Hamann 1991)
  kTetrahedra,  // six tetrahedra around the diagonal of each cell
};
std::string_view name_of(Polygoniser polygoniser);

inline constexpr double kLeastStep = 0x1p-10;  // of an edge

using PolygonCorners = std::array<std::uint32_t, 3>;

struct PolygonMesh {
  std::vector<Vector3d> positions;       // lattice coordinates: corner (x, y, z) is at (x, y, z)
  std::vector<PolygonCorners> polygons;  // counter-clockwise seen from outside
};

// Closed: beyond the lattice all is outside, and the surface lies half an edge before it. Values are finite. Memory grows with one
// layer of the lattice and with what is found.
PolygonMesh polygonise(const ScalarField& field, double level, Polygoniser polygoniser);

// The same by any table, for those who try others.
PolygonMesh polygonise_by(const CellTable& table, const ScalarField& field, double level);

// Where on an edge the surface is, as a share of it from the end with the value `from`: one of them is at least the level.
double crossing(double from, double to, double level);

}  // namespace glassbox::views
