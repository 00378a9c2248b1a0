// The spaces of the viewing pipeline as types, so that only meaningful products compile:
//
//   Transform<Clip, Object> clip_from_object = clip_from_eye * eye_from_world * world_from_object;
//   Point<Clip> p_clip = clip_from_object * p_object;
//
// Vectors are columns, names are target-from-source, and products are read from right to left. The
// components are plain members, which debuggers show and stages read directly; to_glm and the
// constructors from glm::vec convert to and from GLM.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <glassbox/base/numbers.h>

namespace glassbox {

struct Object {};  // the space in which a mesh was modelled
struct World {};   // right-handed; cameras and lights live here
struct Eye {};     // x right, y up, the camera looks down -z
// Homogeneous; w is the distance along the direction of view (1 for parallel projections).
struct Clip {};
struct Ndc {};     // x, y in [-1, 1], y up, z in [0, 1]
struct Screen {};  // pixels from the top left, y down; (i, j) has its centre at (i + 1/2, j + 1/2)

// A position in an affine space.
template <class Space, class T = float>
struct Point {
  using scalar = T;
  T x{}, y{}, z{};

  Point() = default;
  Point(T x_, T y_, T z_) : x(x_), y(y_), z(z_) {}
  explicit Point(const glm::vec<3, T>& v) : x(v.x), y(v.y), z(v.z) {}
  friend bool operator==(const Point&, const Point&) = default;
};

// A position in clip space is homogeneous: (x, y, z, w) and all its positive multiples are the same
// position.
template <class T>
struct Point<Clip, T> {
  using scalar = T;
  T x{}, y{}, z{}, w{};

  Point() = default;
  Point(T x_, T y_, T z_, T w_) : x(x_), y(y_), z(z_), w(w_) {}
  explicit Point(const glm::vec<4, T>& v) : x(v.x), y(v.y), z(v.z), w(v.w) {}
  friend bool operator==(const Point&, const Point&) = default;
};

// A difference of two positions.
template <class Space, class T = float>
struct Vector {
  using scalar = T;
  T x{}, y{}, z{};

  Vector() = default;
  Vector(T x_, T y_, T z_) : x(x_), y(y_), z(z_) {}
  explicit Vector(const glm::vec<3, T>& v) : x(v.x), y(v.y), z(v.z) {}
  friend bool operator==(const Vector&, const Vector&) = default;
};

// A direction perpendicular to a surface. It is transformed by the cofactor matrix, not like a
// Vector.
template <class Space, class T = float>
struct Normal {
  using scalar = T;
  T x{}, y{}, z{};

  Normal() = default;
  Normal(T x_, T y_, T z_) : x(x_), y(y_), z(z_) {}
  explicit Normal(const glm::vec<3, T>& v) : x(v.x), y(v.y), z(v.z) {}
  friend bool operator==(const Normal&, const Normal&) = default;
};

template <class S, class T>
glm::vec<3, T> to_glm(const Point<S, T>& p) {
  return {p.x, p.y, p.z};
}
template <class T>
glm::vec<4, T> to_glm(const Point<Clip, T>& p) {
  return {p.x, p.y, p.z, p.w};
}
template <class S, class T>
glm::vec<3, T> to_glm(const Vector<S, T>& v) {
  return {v.x, v.y, v.z};
}
template <class S, class T>
glm::vec<3, T> to_glm(const Normal<S, T>& n) {
  return {n.x, n.y, n.z};
}

template <class S, class T>
Vector<S, T> operator-(const Point<S, T>& a, const Point<S, T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class S, class T>
Point<S, T> operator+(const Point<S, T>& p, const Vector<S, T>& v) {
  return {p.x + v.x, p.y + v.y, p.z + v.z};
}
template <class S, class T>
Vector<S, T> operator+(const Vector<S, T>& a, const Vector<S, T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class S, class T>
Vector<S, T> operator-(const Vector<S, T>& a, const Vector<S, T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class S, class T>
Vector<S, T> operator-(const Vector<S, T>& v) {
  return {-v.x, -v.y, -v.z};
}
template <class S, class T>
Vector<S, T> operator*(const Vector<S, T>& v, T s) {
  return {v.x * s, v.y * s, v.z * s};
}

// (a.x b.x + a.y b.y) + a.z b.z, summed in this order.
template <class S, class T>
T dot(const Vector<S, T>& a, const Vector<S, T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class S, class T>
T dot(const Normal<S, T>& a, const Vector<S, T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class S, class T>
Vector<S, T> cross(const Vector<S, T>& a, const Vector<S, T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// A 4x4 matrix that takes Source coordinates to Target coordinates. Matrices are composed in double
// and rounded to float once, where a stage applies them.
template <class Target, class Source, class T = double>
struct Transform {
  glm::mat<4, 4, T> columns{T(1)};  // columns[column][row], as GLM and OpenGL store them

  Transform() = default;
  explicit Transform(const glm::mat<4, 4, T>& m) : columns(m) {}

  T& at(int row, int column) { return columns[column][row]; }
  const T& at(int row, int column) const { return columns[column][row]; }
  friend bool operator==(const Transform&, const Transform&) = default;
};

// The product of two transforms: row times column, summed from left to right. This order is fixed,
// so that the result is the same everywhere.
template <class A, class B, class C, class T>
Transform<A, C, T> operator*(const Transform<A, B, T>& a_from_b,
                             const Transform<B, C, T>& b_from_c) {
  Transform<A, C, T> a_from_c;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      a_from_c.at(row, column) = a_from_b.at(row, 0) * b_from_c.at(0, column) +
                                 a_from_b.at(row, 1) * b_from_c.at(1, column) +
                                 a_from_b.at(row, 2) * b_from_c.at(2, column) +
                                 a_from_b.at(row, 3) * b_from_c.at(3, column);
    }
  }
  return a_from_c;
}

#include <glassbox/base/formulas/transform_row.h>

template <class Target, class Source, class T>
T transform_row(const Transform<Target, Source, T>& m, int row, const Point<Source, T>& p) {
  return transform_row(m, row, p.x, p.y, p.z);
}

// A transform between affine spaces has the last row (0, 0, 0, 1), so that row is not read.
template <class Target, class Source, class T>
Point<Target, T> operator*(const Transform<Target, Source, T>& m, const Point<Source, T>& p) {
  return {transform_row(m, 0, p), transform_row(m, 1, p), transform_row(m, 2, p)};
}

template <class Source, class T>
Point<Clip, T> operator*(const Transform<Clip, Source, T>& m, const Point<Source, T>& p) {
  return {transform_row(m, 0, p), transform_row(m, 1, p), transform_row(m, 2, p),
          transform_row(m, 3, p)};
}

template <class Target, class Source, class T>
Vector<Target, T> operator*(const Transform<Target, Source, T>& m, const Vector<Source, T>& v) {
  return {m.at(0, 0) * v.x + m.at(0, 1) * v.y + m.at(0, 2) * v.z,
          m.at(1, 0) * v.x + m.at(1, 1) * v.y + m.at(1, 2) * v.z,
          m.at(2, 0) * v.x + m.at(2, 1) * v.y + m.at(2, 2) * v.z};
}

// Rounds a composed matrix to the precision of the stages. Matrices are rounded to float nowhere
// else.
template <class Target, class Source>
Transform<Target, Source, float> round_to_float(const Transform<Target, Source, double>& m) {
  return Transform<Target, Source, float>(glm::mat<4, 4, float>(m.columns));
}

}  // namespace glassbox
