// Normals of polygons that may have any number of corners and need not be quite flat (S4-15, S4-16;
// B.4).
//
// Newell's sums use every corner and are correct for concave and slightly non-planar polygons. The
// cross product at one corner, as taught in a first course, fails where that corner is reflex
// (C-23) or nearly straight (C-21).
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

#include <glassbox/base/spaces.h>
#include <glassbox/base/trig.h>
#include <glassbox/mesh/mesh.h>

namespace glassbox {

// Twice the vector area of a closed polygon, right-handed: the polygon is counter-clockwise seen
// from the side to which the vector points. Exact arithmetic gives exactly zero for bow-ties and
// for collinear corners (C-24).
//
// The slide (S4.33) sums (y_i - y_n)(z_i + z_n), with n the next corner after i, over the raw
// coordinates. For a polygon of unit size at the distance 10^6 this loses all precision: the sums
// z_i + z_n are large and cancel only at the end. Here coordinates are measured from the first
// corner, so the sums are as small as the polygon; in exact arithmetic the result is the same
// because the sum of all edges is zero (C-22). For N corners, a component of the result has a
// rounding error of at most gamma_(N+3) times the sum of |difference| |sum| over the edges (gamma_k
// is about k times the unit roundoff).
template <class T>
Vector<Object, T> newell_vector(std::span<const Point<Object, T>> polygon) {
  Vector<Object, T> m(T(0), T(0), T(0));
  if (polygon.empty()) return m;
  const Point<Object, T>& origin = polygon.front();
  Vector<Object, T> current(T(0), T(0), T(0));
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector<Object, T> next = polygon[i + 1 == polygon.size() ? 0 : i + 1] - origin;
    m.x += (current.y - next.y) * (current.z + next.z);
    m.y += (current.z - next.z) * (current.x + next.x);
    m.z += (current.x - next.x) * (current.y + next.y);
    current = next;
  }
  return m;
}

// (V2 - V1) x (V3 - V2): twice the vector area of the triangle V1, V2, V3, with the same sign as
// Newell's vector.
//
// There are two traps for polygons with more corners. If the corner V2 is reflex, the sign is
// wrong. If the corners are nearly collinear, errors in the positions turn the normal by about
// their size (relative to the edges) divided by the angle between the two edges. A third trap is in
// the slide itself (S4.32): it writes (V1 - V2) x (V3 - V2), which points the other way (E11,
// C-31).
template <class T>
Vector<Object, T> three_point_normal(const Point<Object, T>& v1, const Point<Object, T>& v2,
                                     const Point<Object, T>& v3) {
  return cross(v2 - v1, v3 - v2);
}

// The angle between two vectors, in [0, pi]; 0 if one of them is zero (S4-14). The arccosine of the
// slide's normalised dot product loses half the digits near 0 and pi, where the cosine is flat; the
// arctangent of |a x b| / (a . b) is correct to a few ulps everywhere.
template <class Space>
double angle_between(const Vector<Space, double>& a, const Vector<Space, double>& b) {
  const Vector<Space, double> across = cross(a, b);
  return arctan2(std::sqrt(dot(across, across)), dot(a, b));
}

// The vector scaled to unit length, computed in double and rounded once; absent where it is zero or
// not finite.
std::optional<Normal<Object>> unit_normal(const Vector<Object, double>& v);

// Newell's vector of a face in double: differences of floats are exact there unless their sizes
// differ by a factor of 2^29.
Vector<Object, double> newell_vector(const Mesh& mesh, const Face& face);

// The unit Newell normal; absent where the face has no area.
std::optional<Normal<Object>> face_normal(const Mesh& mesh, const Face& face);

// Half the length of the Newell vector: the area of a flat face; for a non-planar face, the area of
// its projection onto the mean plane.
double face_area(const Mesh& mesh, const Face& face);

// The largest distance (object units) of a corner from the mean plane, which goes through the mean
// of the corners, perpendicular to the Newell normal. Zero for triangles and for faces without
// area.
double planarity_deviation(const Mesh& mesh, const Face& face);

}  // namespace glassbox
