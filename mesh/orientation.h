// Which side of a surface is its outside, by the winding of its faces.
#pragma once

#include <optional>

#include <glassbox/base/spaces.h>
#include <glassbox/mesh/mesh.h>

namespace glassbox {

// The volume that the faces enclose, in cubic object units: the sum of the signed volumes of the
// cones from one point over all faces (the divergence theorem). It is negative if the faces are
// wound so that their fronts are inside. Absent unless the mesh is closed and wound consistently.
// Takes O(n log n) in the number of corners.
std::optional<double> signed_volume(const Mesh& mesh);

// How often the faces surround a point, by the solid angles under which they are seen from there
// (A. Van Oosterom and J. Strackee, "The Solid Angle of a Plane Triangle", 1983): 1 inside a closed
// surface whose fronts are outside, -1 inside one whose fronts are inside (a room), 0 outside. For
// a surface with holes it is a fraction in between.
double winding_number(const Mesh& mesh, const Point<Object, double>& point);

}  // namespace glassbox
