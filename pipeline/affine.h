// Maps between affine spaces: translation, rotation, scale and shear, and their inverses (S3-02,
// S3-04 .. S3-06).
//
// All matrices are made in double, have the last row (0, 0, 0, 1) and contain no -0. A matrix is
// named target_from_source:
//
//   world_from_object =
//       translate<World, Object>({3, 0, 0}) * *rotate_degrees<Object>({0, 1, 0}, 30);
#pragma once

#include <array>
#include <cmath>

#include <glassbox/base/error.h>
#include <glassbox/base/spaces.h>

namespace glassbox {

// ---- functions on untyped matrices, called by the templates below (affine.cpp) ----

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

// Adds factor * (coordinate `by`) to the coordinate `changed`: shear(kX, kY, 1) moves a point
// towards +x by its height y. The two axes must differ.
template <class Target, class Source = Target>
Transform<Target, Source> shear(Axis changed, Axis by, double factor) {
  Transform<Target, Source> m;
  m.at(int(changed), int(by)) = factor;
  return m;
}

// A rotation, counter-clockwise when the axis points at the viewer (Rodrigues' formula). The axis
// may have any length. A zero, NaN or infinite axis is an error, and so is an angle beyond
// kMaxDegrees. The entries are within 8 u (u is the unit roundoff, 2^-53) of the exact rotation's;
// they are exact for axes along x, y or z with multiples of 90 degrees.
template <class Target, class Source = Target>
Result<Transform<Target, Source>> rotate_degrees(const Vector<Source, double>& axis,
                                                 double degrees) {
  return affine::rotation(to_glm(axis), degrees).map([](const glm::dmat4& m) {
    return Transform<Target, Source>(m);
  });
}

// ---- inverses ----

// The inverse of a rotation R followed by a translation t: the rotation R^T followed by the
// translation -R^T t. Nothing is checked: if the matrix is not such a product, the result is wrong.
template <class Target, class Source>
Transform<Source, Target> inverse_rigid(const Transform<Target, Source>& m) {
  return Transform<Source, Target>(affine::inverse_rigid(m.columns));
}

// The inverse of any invertible affine map, by cofactors. It is an error if the matrix is not
// finite, or if the map flattens space so much that the sign of its determinant is not known (|det|
// <= 16 u times the sum of the absolute values of the determinant's terms, where u is the unit
// roundoff).
template <class Target, class Source>
Result<Transform<Source, Target>> inverse_affine(const Transform<Target, Source>& m) {
  return affine::inverse(m.columns).map(
      [](const glm::dmat4& inverse) { return Transform<Source, Target>(inverse); });
}

// ---- the axis and angle of a rotation; the rotation nearest to a matrix ----

struct AxisAngle {
  glm::dvec3 axis{0, 0, 1};  // unit length
  double radians = 0;        // 0 .. pi
};

// The axis and the angle of a rotation matrix R (S3-06). The axis is computed from R - R^T. The
// angle is atan2(sine, cosine), which stays accurate near 0, where an arccosine loses half of the
// digits (C-04). Beyond 90 degrees the axis is computed from R + R^T, which is well-conditioned up
// to and at 180 degrees (C-05; at 180 degrees both directions of the axis are correct). The
// identity gives the z axis. Only the upper 3x3 is read, and it must be a rotation.
AxisAngle axis_angle_of(const glm::dmat4& rotation);
template <class Target, class Source>
AxisAngle axis_angle_of(const Transform<Target, Source>& rotation) {
  return axis_angle_of(rotation.columns);
}

// The rotation nearest to a matrix (its polar factor), and its distance from the matrix. It repairs
// drift from repeated products (C-11) and data with few digits (C-12). It is an error if no
// rotation is near: for a reflection, or a matrix without full rank.
struct NearestRotation {
  glm::dmat3 rotation{1};
  double largest_change = 0;  // largest change of an entry
};
Result<NearestRotation> nearest_rotation(const glm::dmat3& matrix);

// Largest entry of |R^T R - I| for the matrix R: 0 for exact rotations and reflections, a few u
// (the unit roundoff) for rounded ones.
double orthogonality_error(const glm::dmat3& matrix);

// ---- affine maps from correspondences (S3-05) ----

// An affine map that was found from corresponding points. `condition` says how much a relative
// error of the given points is magnified in the map: the 1-norm of the source's edge matrix times
// that of its inverse. It grows like 1/sin of the smallest angle between the edges.
struct AffineFit {
  glm::dmat4 matrix{1};
  double condition = 1;
};

// The affine map of the plane that maps each of three source points to its target point; z is
// unchanged. Six equations determine its six unknown entries. It is an error if the source points
// are on one line.
Result<AffineFit> affine_from_three_points(const std::array<glm::dvec2, 3>& source,
                                           const std::array<glm::dvec2, 3>& target);

// The affine map of space that maps each of four source points to its target point. It is an error
// if the source points are in one plane.
Result<AffineFit> affine_from_four_points(const std::array<glm::dvec3, 4>& source,
                                          const std::array<glm::dvec3, 4>& target);

}  // namespace glassbox
