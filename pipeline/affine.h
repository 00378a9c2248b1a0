// Maps between affine spaces: translate, rotate, scale, shear, and the ways back (S3-02, S3-04 .. S3-06).
//
// All are made in double, have the last row (0, 0, 0, 1), contain no -0, and read as target from source:
//
//   world_from_object = translate<World, Object>({3, 0, 0}) * *rotate_degrees<Object>({0, 1, 0}, 30);
#pragma once

#include <array>
#include <cmath>

#include <glassbox/base/error.h>
#include <glassbox/base/spaces.h>

namespace glassbox {

// ---- the same on bare matrices (affine.cpp) ----

namespace affine {
Result<glm::dmat4> rotation(const glm::dvec3& axis, double degrees);
glm::dmat4 inverse_rigid(const glm::dmat4& m);
Result<glm::dmat4> inverse(const glm::dmat4& m);
}  // namespace affine

// ---- building blocks ----

template <class Target, class Source = Target>
Transform<Target, Source> translate(const Vector<Target, double>& offset) {
  Transform<Target, Source> m;
  m.at(0, 3) = offset.x;
  m.at(1, 3) = offset.y;
  m.at(2, 3) = offset.z;
  return m;
}

template <class Target, class Source = Target>
Transform<Target, Source> scale(double x, double y, double z) {
  Transform<Target, Source> m;
  m.at(0, 0) = x;
  m.at(1, 1) = y;
  m.at(2, 2) = z;
  return m;
}

enum class Axis { kX = 0, kY = 1, kZ = 2 };

// Adds factor * (coordinate `by`) to the coordinate `changed`: shear(kX, kY, 1) leans towards +x with height. The axes
// must differ.
template <class Target, class Source = Target>
Transform<Target, Source> shear(Axis changed, Axis by, double factor) {
  Transform<Target, Source> m;
  m.at(int(changed), int(by)) = factor;
  return m;
}

// Counter-clockwise when the axis points at the viewer (Rodrigues). The axis may have any length; zero, NaN and
// infinite ones are errors, and so are angles beyond kMaxDegrees. Entries are within 8 u of a rotation's; axes along
// x, y, z and multiples of 90 degrees are exact.
template <class Target, class Source = Target>
Result<Transform<Target, Source>> rotate_degrees(const Vector<Source, double>& axis,
                                                 double degrees) {
  return affine::rotation(to_glm(axis), degrees).map([](const glm::dmat4& m) {
    return Transform<Target, Source>(m);
  });
}

// ---- inverses ----

// For rotations with translation: R^T, -R^T t. Nothing is checked; what is not rigid comes out wrong.
template <class Target, class Source>
Transform<Source, Target> inverse_rigid(const Transform<Target, Source>& m) {
  return Transform<Source, Target>(affine::inverse_rigid(m.columns));
}

// For any invertible affine map, by cofactors. An error if the map flattens space so far that the sign of its
// determinant is not known (|det| <= 16 u times the sum of the determinant's terms without their signs), or is not
// finite.
template <class Target, class Source>
Result<Transform<Source, Target>> inverse_affine(const Transform<Target, Source>& m) {
  return affine::inverse(m.columns).map(
      [](const glm::dmat4& inverse) { return Transform<Source, Target>(inverse); });
}

// ---- rotations taken apart and repaired ----

struct AxisAngle {
  glm::dvec3 axis{0, 0, 1};  // unit length
  double radians = 0;        // 0 .. pi
};

// Which rotation is this (S3-06)? The axis from R - R^T, the angle from atan2(sine, cosine), which keeps its digits
// near 0 where an arccosine loses half of them (C-04); beyond 90 degrees the axis comes from R + R^T, which is
// well-conditioned up to and at 180 degrees (C-05; there both directions of the axis are right). The identity gives
// the z axis. Only the upper 3x3 is read, and it must be a rotation.
AxisAngle axis_angle_of(const glm::dmat4& rotation);
template <class Target, class Source>
AxisAngle axis_angle_of(const Transform<Target, Source>& rotation) {
  return axis_angle_of(rotation.columns);
}

// The rotation nearest to a matrix (its polar factor), and how far away that was: drift from repeated products (C-11)
// or data with few digits (C-12). An error if there is none near: a reflection, or a matrix without full rank.
struct NearestRotation {
  glm::dmat3 rotation{1};
  double moved = 0;  // largest change of an entry
};
Result<NearestRotation> nearest_rotation(const glm::dmat3& matrix);

// Largest entry of |R^T R - I|: 0 for exact rotations and reflections, a few u for rounded ones.
double orthogonality_error(const glm::dmat3& matrix);

// ---- affine maps from correspondences (S3-05) ----

// `condition`: how much a relative error of the given points is magnified in the map (1-norm of the source's edge matrix
// times that of its inverse). It grows like 1/sin of the smallest angle between the edges.
struct AffineFit {
  glm::dmat4 matrix{1};
  double condition = 1;
};

// The map of the plane that carries three points to three others; z stays. Six equations, six unknowns. An error if the
// source points lie on a line.
Result<AffineFit> affine_from_three_points(const std::array<glm::dvec2, 3>& source,
                                           const std::array<glm::dvec2, 3>& target);

// The map of space that carries four points to four others. An error if the source points lie in a plane.
Result<AffineFit> affine_from_four_points(const std::array<glm::dvec3, 4>& source,
                                          const std::array<glm::dvec3, 4>& target);

}  // namespace glassbox
