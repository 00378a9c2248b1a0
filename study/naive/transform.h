// Matrix products as beginners first write them.
#pragma once

#include <glm/gtc/matrix_inverse.hpp>
#include <glm/matrix.hpp>

#include <glassbox/base/spaces.h>

namespace glassbox::study::naive {

// ---- products ----

// The product in the wrong order: B A instead of A B.
inline glm::dmat4 premultiplied(const glm::dmat4& a, const glm::dmat4& b) {
  return b * a;
}

// Rounds world positions to float: far from the origin, the spacing of floats is larger than the
// object.
inline Point<Eye> through_float_world(const Transform<Eye, World>& eye_from_world,
                                      const Transform<World, Object>& world_from_object,
                                      const Point<Object>& p) {
  const Point<World> world = round_to_float(world_from_object) * p;
  return round_to_float(eye_from_world) * world;
}

// Uses one combined matrix, but multiplies it in float: the translations of both matrices are
// rounded before they cancel.
inline Point<Eye> composed_in_float(const Transform<Eye, World>& eye_from_world,
                                    const Transform<World, Object>& world_from_object,
                                    const Point<Object>& p) {
  return (round_to_float(eye_from_world) * round_to_float(world_from_object)) * p;
}

// ---- normals ----

// Transforms normals with the matrix of the positions.
inline Normal<World> normal_by_matrix(const Transform<World, Object>& m, const Normal<Object>& n) {
  const glm::mat3 linear(m.columns);
  return Normal<World>(linear * to_glm(n));
}

// Transforms normals with the inverse transpose, which is 1/0 for a matrix that flattens the
// object.
inline Normal<World> normal_by_inverse_transpose(const Transform<World, Object>& m,
                                                 const Normal<Object>& n) {
  return Normal<World>(glm::inverseTranspose(glm::mat3(m.columns)) * to_glm(n));
}

inline glm::dmat3 cofactors(const glm::dmat3& m) {
  return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

// Uses cofactors without the sign of the determinant: normals of a mirrored model point inwards.
inline Normal<World> normal_without_sign(const Transform<World, Object>& m,
                                         const Normal<Object>& n) {
  return Normal<World>(glm::mat3(cofactors(glm::dmat3(m.columns))) * to_glm(n));
}

// Uses the matrix of cofactors with rows and columns exchanged.
inline Normal<World> normal_by_transposed_cofactors(const Transform<World, Object>& m,
                                                    const Normal<Object>& n) {
  const glm::dmat3 linear(m.columns);
  const double sign = glm::determinant(linear) < 0 ? -1 : 1;
  return Normal<World>(glm::mat3(glm::transpose(cofactors(linear)) * sign) * to_glm(n));
}

}  // namespace glassbox::study::naive
