// Shared code of the cases about transformed normals: compares a normal with the exact one from
// cofactors.
#pragma once

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/normal_transform.h>

#include "study/extremes/common/drawn_normals.h"
#include "study/extremes/common/polygons.h"

namespace glassbox::study {

using TransformNormal = Normal<World> (*)(const Transform<World, Object>&, const Normal<Object>&);

inline Normal<World> by_cofactors(const Transform<World, Object>& m, const Normal<Object>& n) {
  return normalized(normal_transform(m) * n);
}

// The signed cofactors of this very matrix times this very normal, in rational numbers.
inline Vector<Object, exact::Rational> exact_normal(const Transform<World, Object>& m,
                                                    const Normal<Object>& n) {
  using V = Vector<Object, exact::Rational>;
  const auto column = [&](int k) {
    return V(exact::Rational(m.at(0, k)), exact::Rational(m.at(1, k)), exact::Rational(m.at(2, k)));
  };
  const V cofactors[] = {cross(column(1), column(2)), cross(column(2), column(0)),
                         cross(column(0), column(1))};
  const exact::Rational sign(dot(column(0), cofactors[0]) < 0 ? -1 : 1);
  return cofactors[0] * (sign * exact::Rational(double(n.x))) +
         cofactors[1] * (sign * exact::Rational(double(n.y))) +
         cofactors[2] * (sign * exact::Rational(double(n.z)));
}

// A triangle in the plane z = 0 with this normal at its corners.
inline Mesh triangle_with_normal(const Normal<Object>& n) {
  Mesh mesh = mesh_of(Polygon{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}});
  mesh.normals = {n};
  for (Corner& corner : mesh.corners) corner.normal = 0;
  return mesh;
}

inline double normal_error(const Normal<World>& normal, const Transform<World, Object>& m,
                           const Normal<Object>& n) {
  return angle_to({double(normal.x), double(normal.y), double(normal.z)}, exact_normal(m, n));
}

}  // namespace glassbox::study
