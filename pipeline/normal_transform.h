// Normals under a transform: by the matrix of cofactors, which needs no inverse and no division.
#pragma once

#include <glm/mat3x3.hpp>

#include <cmath>

#include <glassbox/base/spaces.h>

namespace glassbox {

// The cofactors of the upper 3x3, times the sign of its determinant (so that outward normals stay outward under
// mirroring, C-17) and a power of two (so that nothing overflows), computed in double and rounded to float once. Where
// an inverse exists this is a positive multiple of the inverse transpose; where the map flattens space it is still
// right for the faces that survive (C-18), and 0 for those that do not.
template <class Target, class Source>
struct NormalTransform {
  glm::mat3 columns{1};  // columns[column][row]

  float at(int row, int column) const { return columns[column][row]; }
};

namespace normals {
// `linear`: the upper 3x3 of the transform of positions.
glm::dmat3 signed_cofactors(const glm::dmat3& linear);
}  // namespace normals

template <class Target, class Source>
NormalTransform<Target, Source> normal_transform(const Transform<Target, Source>& positions) {
  return {glm::mat3(normals::signed_cofactors(glm::dmat3(positions.columns)))};
}

// Not of unit length. Row times column, from left to right, in float.
template <class Target, class Source>
Normal<Target> operator*(const NormalTransform<Target, Source>& m, const Normal<Source>& n) {
  return {m.at(0, 0) * n.x + m.at(0, 1) * n.y + m.at(0, 2) * n.z,
          m.at(1, 0) * n.x + m.at(1, 1) * n.y + m.at(1, 2) * n.z,
          m.at(2, 0) * n.x + m.at(2, 1) * n.y + m.at(2, 2) * n.z};
}

// n/|n|, the length taken in double, where squares of floats neither overflow nor vanish. Zero stays zero.
template <class Space>
Normal<Space> normalized(const Normal<Space>& n) {
  const double x = n.x, y = n.y, z = n.z;
  const double length = std::sqrt(x * x + y * y + z * z);
  if (!(length > 0)) return n;
  return {float(x / length), float(y / length), float(z / length)};
}

}  // namespace glassbox
