// Lab 1: meshes, tables, adjacency, normals. The contracts of the five functions that you write in
// student.cpp.
//
// Everything is in object space, right-handed, in object units. The corners of a face run
// counter-clockwise when it is seen from outside. Positions are floats, as files and graphics cards
// have them; compute in float or double as you think fit. u = 2^-24 is the unit roundoff of float;
// gamma(k) = k u / (1 - k u) bounds the relative error of k roundings in a row.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glassbox/base/spaces.h>
#include <glassbox/mesh/mesh.h>

namespace lab_01 {

// The types of <glassbox/base/spaces.h>, which comes with glassbox; this is all that you need:
//   Point<Object>           p.x, p.y, p.z, floats; p - q is a Vector, p + v a Point
//   Vector<Object, double>  v.x, v.y, v.z; v + w, v - w, -v, v * number; dot(v, w), cross(v, w);
//                           Vector<Object> has floats
using glassbox::Mesh;
using glassbox::Object;
using glassbox::Point;
using glassbox::Vector;

// Task 1.1. Reads the vertex and face tables from a text in which every line is one of
//
//   v X Y Z        a position
//   f I J K ...    a polygon of three or more corners: numbers of positions, the first being 1;
//                  -1 is the last position read so far, -2 the one before it. All numbers are
//                  below 2^62 in size.
//   # anything     a comment; it may also end another line. Empty lines and further spaces mean
//                  nothing.
//
// Fills `positions`, `corners` and `faces` (<glassbox/mesh/mesh.h>). The corners of all faces are
// in one table. A Face is {the index of its first corner in that table, how many corners it has},
// and a Corner has its `position`, counted from 0. Everything else stays empty or kNone. Numbers
// become the nearest floats, which may be subnormal or 0; none is too large for a float.
// Throws std::invalid_argument where a corner names no position read so far (number 0 included), a
// face has fewer than three corners, or a position has fewer than three numbers.
Mesh read_mesh(const std::string& text);

// An edge: two vertices, and how often faces pass along it in each direction. A face that passes
// along it twice counts twice.
struct Edge {
  std::uint32_t low = 0, high = 0;  // positions, low < high
  int ascending = 0;                // how often faces pass from low to high
  int descending = 0;               // how often faces pass from high to low
};

struct EdgeTable {
  std::vector<Edge> edges;  // each pair once, sorted by low, then by high
  int euler = 0;            // V - E + F
  bool closed = false;      // faces pass along every edge exactly twice, and some face takes part
};

// Task 1.2. The edges of a mesh. A face passes along an edge from each corner to the next and from
// the last corner to the first. A position that the next corner of the face repeats counts once. A
// face with no corners, or with fewer than three different positions takes no part: it has no edges
// and is not counted in F. V counts the positions of the faces that take part.
EdgeTable find_edges(const Mesh& mesh);

// Task 1.3. Which faces must be turned round (their corners reversed) so that every edge of two
// faces is passed once in each direction: one number for each face, 1 to turn it and 0 to leave it.
// In each group of faces that are connected across edges, the first one in the table is never
// turned. Returns std::nullopt if it cannot be done: the surface then has one side only. The mesh
// has no edge of more than two faces, and no face repeats a position.
std::optional<std::vector<int>> faces_to_turn(const Mesh& mesh);

// Task 1.4. Newell's vector of a closed polygon of three or more corners: its length is twice the
// polygon's area, and it points to the side from which the corners run counter-clockwise. Exactly
// zero if all corners are the same point.
// Error bound of each component: gamma(N + 4) 4 N L^2, where N is the number of corners and L the
// largest difference of a coordinate from that of the first corner. It does not depend on how far
// away the polygon is. Coordinates are at most 2^20 in size. L is 0 or at least 2^-50, so that
// no product that matters is too small for float.
Vector<Object> newell_vector(const std::vector<Point<Object>>& polygon);

// Task 1.5. The angle between two vectors in radians, in [0, pi]. Neither is zero; components are
// integers up to 2^25 in size, so that their products are exact in double. Relative error at most
// 16 * 2^-53, for small angles too.
double angle_between(const Vector<Object, double>& a, const Vector<Object, double>& b);

}  // namespace lab_01
