// Lab 1: meshes, tables, adjacency, normals. The contracts of the five functions that you write in student.cpp.
//
// Everything is in object space, right-handed, in object units. A face is counter-clockwise seen from outside. Positions
// are floats, as files and graphics cards have them; compute in float or double as you think fit. u = 2^-24 is the
// rounding unit of float, gamma(k) = k u / (1 - k u) the bound of k roundings in a row.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glassbox/base/spaces.h>
#include <glassbox/mesh/mesh.h>

namespace lab_01 {

using glassbox::Mesh;
using glassbox::Object;
using glassbox::Point;
using glassbox::Vector;

// Task 1.1. The vertex and face tables of a text in which every line is one of
//
//   v X Y Z        a position
//   f I J K ...    a polygon of three or more corners: numbers of positions, the first being 1; -1 is the last position
//                  read so far, -2 the one before it
//   # anything     a comment; it may also end another line. Empty lines and further spaces mean nothing.
//
// Fills `positions`, `corners` and `faces` (<glassbox/mesh/mesh.h>): the corners of all faces stand in one table, a Face is
// {the number of its first one, how many it has}, and a Corner has its `position`, counted from 0. Everything else stays empty or kNone.
// Throws std::invalid_argument where a corner names no position read so far (number 0 included), a face has fewer than
// three corners, or a position fewer than three numbers. Numbers are the nearest floats.
Mesh read_mesh(const std::string& text);

// Two vertices and how faces pass between them.
struct Edge {
  std::uint32_t low = 0, high = 0;  // positions, low < high
  int ascending = 0;                // faces that pass from low to high
  int descending = 0;               // faces that pass from high to low
};

struct EdgeTable {
  std::vector<Edge> edges;  // each pair once, sorted by low, then by high
  int euler = 0;            // V - E + F
  bool closed = false;      // every edge has exactly two faces, and there are faces
};

// Task 1.2. The edges of a mesh. A face goes along an edge from each corner to the next and from the last to the first.
// A position that is repeated by the next corner of the face counts once. A face with fewer than three different positions
// takes no part: it has no edges and is not in F. V counts the positions of the faces that take part.
EdgeTable find_edges(const Mesh& mesh);

// Task 1.3. Which faces must be turned round (their corners reversed) so that every edge of two faces is passed once in each
// direction: one number for each face, 1 to turn it and 0 to leave it. Of the faces that hang together across edges,
// the first in the table is never turned. Nothing if it cannot be done: the surface has one side only.
// The mesh has no edge of more than two faces, and no face repeats a position.
std::optional<std::vector<int>> faces_to_turn(const Mesh& mesh);

// Task 1.4. Newell's vector of a closed polygon of three or more corners: twice its area, along the side from which the
// corners run counter-clockwise. Exactly zero if all corners are the same point.
// Bound of each component: gamma(N + 4) 4 N L^2, where N is the number of corners and L the largest difference of a coordinate
// from the first corner. It does not depend on how far away the polygon is. Coordinates up to 2^20.
Vector<Object> newell_vector(const std::vector<Point<Object>>& polygon);

// Task 1.5. The angle between two vectors in radians, in [0, pi]. Neither is zero; components are integers up to 2^25 in size,
// so that their products are exact in double. Relative error at most 16 * 2^-53, for small angles too.
double angle_between(const Vector<Object, double>& a, const Vector<Object, double>& b);

}  // namespace lab_01
