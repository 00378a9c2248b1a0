// Normals and facing tests as beginners first write them.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>

#include <glassbox/mesh/normals.h>
#include <glassbox/pipeline/back_face.h>

namespace glassbox::study::naive {

// The normal from the cross product of two edges at the first corner, in float.
inline Vector<Object, double> first_corner(std::span<const Point<Object>> polygon) {
  const auto m = three_point_normal(polygon[0], polygon[1], polygon[2]);
  return {m.x, m.y, m.z};
}

// Newell's sums of the raw coordinates, exactly as on the slide (S4.33). Far from the origin the
// terms are large and cancel only at the end.
template <class T>
Vector<Object, double> raw_newell(std::span<const Point<Object>> polygon) {
  T x = 0, y = 0, z = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point<Object>&p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    x += (T(p.y) - T(q.y)) * (T(p.z) + T(q.z));
    y += (T(p.z) - T(q.z)) * (T(p.x) + T(q.x));
    z += (T(p.x) - T(q.x)) * (T(p.y) + T(q.y));
  }
  return {double(x), double(y), double(z)};
}

// Newell's sums with one sign changed: differences are multiplied by differences instead of sums.
inline Vector<Object, double> newell_of_differences(std::span<const Point<Object>> polygon) {
  Vector<Object, double> m;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point<Object>&p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double x = double(p.x) - double(q.x), y = double(p.y) - double(q.y);
    const double z = double(p.z) - double(q.z);
    m = m + Vector<Object, double>(y * z, z * x, x * y);
  }
  return m;
}

// Newell's sums without the edge from the last corner to the first, and with a second mistake in z.
inline Vector<Object, double> open_newell(std::span<const Point<Object>> polygon) {
  Vector<Object, double> m;
  for (std::size_t i = 0; i + 1 < polygon.size(); ++i) {
    const Vector<Object, float> a = polygon[i] - polygon[0], b = polygon[i + 1] - polygon[0];
    m.x += (double(a.y) - double(b.y)) * (double(a.z) + double(b.z));
    m.y += (double(a.z) - double(b.z)) * (double(a.x) + double(b.x));
    // A mistake: the second factor uses x instead of y.
    m.z += (double(a.x) - double(b.x)) * (double(a.x) + double(b.x));
  }
  return m;
}

// The normal (V1 - V2) x (V3 - V2), exactly as on the slide (S4.32). Its direction is opposite to
// the right one.
inline Vector<Object, double> slide_32(std::span<const Point<Object>> polygon) {
  const auto m = cross(polygon[0] - polygon[1], polygon[2] - polygon[1]);
  return {m.x, m.y, m.z};
}

// The facing of a polygon from the sign of (P - eye) . m, where P is a corner and m the normal. It
// is computed in the type T, and rounding may change the sign.
template <class T>
Facing facing(std::span<const Point<Object>> polygon, const ObjectViewer& viewer) {
  using V = Vector<Object, T>;
  const auto at = [&](std::size_t i) {
    return Point<Object, T>(T(polygon[i].x), T(polygon[i].y), T(polygon[i].z));
  };
  const Vector<Object, double>& e = viewer.eye_or_gaze;
  const V sight = viewer.perspective ? at(0) - Point<Object, T>(T(e.x), T(e.y), T(e.z))
                                     : V(T(e.x), T(e.y), T(e.z));
  const T value = dot(sight, cross(at(1) - at(0), at(2) - at(1)));
  return value > 0 ? Facing::kBack : value < 0 ? Facing::kFront : Facing::kEdgeOn;
}

}  // namespace glassbox::study::naive
