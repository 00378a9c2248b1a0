// Positions and normals in eye space, computed in arithmetic of 320 bits from the matrices.
#pragma once

#include <array>

#include "tests/raster/exact_formulas.h"
#include "tests/render/exact_polygon.h"

namespace glassbox::test {

using Big3 = std::array<Big, 3>;

inline Big3 affine(const BigMatrix& m, const Point<Object>& p) {
  Big3 at;
  for (std::size_t i = 0; i < 3; ++i) {
    at[i] = m[i][0] * Big(p.x) + m[i][1] * Big(p.y) + m[i][2] * Big(p.z) + m[i][3];
  }
  return at;
}

inline Big3 negated(const Big3& v) {
  return {-v[0], -v[1], -v[2]};
}

inline Big3 unit_of(const Big3& v) {
  const Big length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  return {v[0] / length, v[1] / length, v[2] / length};
}

// The normal in eye space, by the cofactors of the matrix.
inline Big3 eye_normal(const BigMatrix& eye, const Big3& n) {
  Big3 normal;
  Big determinant = 0;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
      const Big cofactor = eye[r1][c1] * eye[r2][c2] - eye[r1][c2] * eye[r2][c1];
      normal[r] += cofactor * n[c];
      if (r == 0) determinant += eye[0][c] * cofactor;
    }
  }
  return unit_of(determinant < 0 ? negated(normal) : normal);
}

inline Big3 face_normal_of(const TracedTriangle& triangle) {
  std::array<Big3, 3> p;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point<Object>& at = triangle.corners[k].object;
    p[k] = {Big(at.x), Big(at.y), Big(at.z)};
  }
  const Big3 a{p[1][0] - p[0][0], p[1][1] - p[0][1], p[1][2] - p[0][2]};
  const Big3 b{p[2][0] - p[0][0], p[2][1] - p[0][1], p[2][2] - p[0][2]};
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace glassbox::test
