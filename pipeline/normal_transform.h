// Transforms normals by the matrix of cofactors, which needs no inverse and no division.
#pragma once

#include <glm/mat3x3.hpp>

#include <array>

#include <glassbox/base/spaces.h>
#include <glassbox/pipeline/formulas.h>

namespace glassbox {

// The cofactors of the upper 3x3, times the sign of its determinant (so that outward normals stay
// outward under mirroring, C-17) and a power of two (so that nothing overflows), computed in double
// and rounded to float once. Where an inverse exists this is a positive multiple of the inverse
// transpose. Where the map flattens space it is still correct for the faces that keep an area
// (C-18), and 0 for the faces that lose theirs.
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

// Each row times the normal, summed from left to right, in float. The result is not of unit length.
template <class Target, class Source>
Normal<Target> operator*(const NormalTransform<Target, Source>& m, const Normal<Source>& n) {
  const std::array<float, 3> from{n.x, n.y, n.z};
  return {transform_normal_row(m, 0, from), transform_normal_row(m, 1, from),
          transform_normal_row(m, 2, from)};
}

template <class Space>
Normal<Space> normalized(const Normal<Space>& n) {
  const auto [x, y, z] = unit_normal(std::array<float, 3>{n.x, n.y, n.z});
  return {x, y, z};
}

}  // namespace glassbox
