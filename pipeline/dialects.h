// Other common conventions for coordinates and matrices, and the conversions between them and ours
// (docs/conventions.md).
//
//   ours                      dialect                     adaptor
//   Eye: looks down -z        EyeLeft: z into the scene   eye_left_from_eye (its own inverse)
//   Clip: 0 <= z <= w         ClipGl: -w <= z <= w        clip_gl_from_clip, clip_from_clip_gl
//   depth 0 near, 1 far       1 near, 0 far               reverse_depth (its own inverse)
//   column vectors            row vectors                 row_vector_matrix
//   column-major storage      row-major storage           row_major, from_row_major
#pragma once

#include <array>

#include <glassbox/base/spaces.h>

namespace glassbox {

// The left-handed eye of S3.24-33 and S4.9-20 (Watt's form): x right, y up, z the distance along
// the gaze.
struct EyeLeft {};

// OpenGL's clip space, z in [-w, w] (S4.21). Matrices into it multiply like all others; a point in
// it is a glm::dvec4.
struct ClipGl {};

// S = diag(1, 1, -1, 1). A matrix T written for the left-handed eye becomes ours as T *
// eye_left_from_eye(). Without this factor everything in front of the camera gets w < 0, and what
// is behind the camera is drawn (E12, C-07).
inline Transform<EyeLeft, Eye> eye_left_from_eye() {
  Transform<EyeLeft, Eye> s;
  s.at(2, 2) = -1;
  return s;
}
inline Transform<Eye, EyeLeft> eye_from_eye_left() {
  return Transform<Eye, EyeLeft>(eye_left_from_eye().columns);
}

// z' = 2z - w, so that depth 0 .. 1 becomes -1 .. 1. The near plane is z >= 0 before and z >= -w
// after. It is a well-known mistake to clip the vertices of one dialect by the near plane of the
// other (E16, C-41).
inline Transform<ClipGl, Clip> clip_gl_from_clip() {
  Transform<ClipGl, Clip> m;
  m.at(2, 2) = 2;
  m.at(2, 3) = -1;
  return m;
}
// z' = (z + w)/2, so that depth -1 .. 1 becomes 0 .. 1.
inline Transform<Clip, ClipGl> clip_from_clip_gl() {
  Transform<Clip, ClipGl> m;
  m.at(2, 2) = 0.5;
  m.at(2, 3) = 0.5;
  return m;
}
constexpr double gl_depth_from_depth(double z) {
  return 2 * z - 1;
}
constexpr double depth_from_gl_depth(double z_gl) {
  return (z_gl + 1) / 2;
}

// z' = w - z: depth 1 at the near plane. This is correct after any clip matrix, but the subtraction
// cancels digits. So the projections of projection.h do not use it: they have formulas of their own
// for reversed depth.
inline Transform<Clip, Clip> reverse_depth() {
  Transform<Clip, Clip> m;
  m.at(2, 2) = -1;
  m.at(2, 3) = 1;
  return m;
}
constexpr double reversed_depth(double z) {
  return 1 - z;
}

// The stereo skew of S0.21, applied in eye space before the projection: x' = x + s (1 - z/f), where
// z is the distance along the gaze, s is `shift` and f is `focus`. So points at the distance f do
// not move. The slide's left-handed form has -s/f at [0][2]; for an eye that looks down -z the sign
// of that entry is the opposite. `shift` is in world units (half the interaxial distance for the
// left eye, minus that for the right one); `focus` > 0 in world units.
inline Transform<EyeLeft, EyeLeft> stereo_skew_left_handed(double shift, double focus) {
  Transform<EyeLeft, EyeLeft> m;
  m.at(0, 2) = -shift / focus;
  m.at(0, 3) = shift;
  return m;
}
inline Transform<Eye, Eye> stereo_skew(double shift, double focus) {
  Transform<Eye, Eye> m;
  m.at(0, 2) = shift / focus;
  m.at(0, 3) = shift;
  return m;
}

// ---- storage ----
// Our matrices multiply column vectors, and GLM and OpenGL store one column after the other: m[4
// column + row]. A library of row vectors (v' = v M) that stores one row after the other has the
// same sixteen numbers in the same order for the same map, because two transpositions cancel.

using Matrix16 = std::array<double, 16>;

template <class Target, class Source>
Matrix16 column_major(const Transform<Target, Source>& m) {
  Matrix16 out{};
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) out[std::size_t(4 * column + row)] = m.at(row, column);
  }
  return out;
}
template <class Target, class Source>
Matrix16 row_major(const Transform<Target, Source>& m) {
  Matrix16 out{};
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column)
      out[std::size_t(4 * row + column)] = m.at(row, column);
  }
  return out;
}
template <class Target, class Source>
Transform<Target, Source> from_column_major(const Matrix16& numbers) {
  Transform<Target, Source> m;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) m.at(row, column) = numbers[std::size_t(4 * column + row)];
  }
  return m;
}
template <class Target, class Source>
Transform<Target, Source> from_row_major(const Matrix16& numbers) {
  Transform<Target, Source> m;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column)
      m.at(row, column) = numbers[std::size_t(4 * row + column)];
  }
  return m;
}

// The matrix of the same map for row vectors, p' = p M: the transpose. Products of such matrices
// are written in the opposite order.
template <class Target, class Source>
glm::dmat4 row_vector_matrix(const Transform<Target, Source>& m) {
  glm::dmat4 transposed;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) transposed[row][column] = m.at(row, column);
  }
  return transposed;
}

}  // namespace glassbox
