// Vectors and 4x4 matrices of exact numbers, or of any type with + and *.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <glassbox/base/random.h>
#include <glassbox/base/spaces.h>

namespace glassbox::exact {

template <class N>
using Vector4 = std::array<N, 4>;

template <class N>
struct Matrix4 {
  std::array<std::array<N, 4>, 4> at{};  // [row][column]

  static Matrix4 identity() {
    Matrix4 m;
    for (std::size_t i = 0; i < 4; ++i) m.at[i][i] = 1;
    return m;
  }
};

template <class N>
Matrix4<N> operator*(const Matrix4<N>& a, const Matrix4<N>& b) {
  Matrix4<N> product;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 4; ++k) product.at[i][j] += a.at[i][k] * b.at[k][j];
    }
  }
  return product;
}

template <class N>
Vector4<N> operator*(const Matrix4<N>& m, const Vector4<N>& v) {
  Vector4<N> product{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 4; ++k) product[i] += m.at[i][k] * v[k];
  }
  return product;
}

// Converts a matrix of doubles or floats to exact numbers, without rounding.
template <class N, class Target, class Source, class T>
Matrix4<N> exactly(const Transform<Target, Source, T>& m) {
  Matrix4<N> exact;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) exact.at[std::size_t(i)][std::size_t(j)] = N(double(m.at(i, j)));
  }
  return exact;
}

template <class N, class Space, class T>
Vector4<N> exactly(const Point<Space, T>& p) {
  return {N(double(p.x)), N(double(p.y)), N(double(p.z)), N(1)};
}
template <class N, class T>
Vector4<N> exactly(const Point<Clip, T>& p) {
  return {N(double(p.x)), N(double(p.y)), N(double(p.z)), N(double(p.w))};
}

// A rotation matrix made from a quaternion (a, b, c, d) of small integers. Each entry is an integer
// divided by a^2 + b^2 + c^2 + d^2, so numerator and denominator are stored without rounding.
struct PythagoreanRotation {
  std::int64_t denominator = 1;
  std::array<std::array<std::int64_t, 3>, 3> numerator{};  // [row][column]
};

inline PythagoreanRotation pythagorean_rotation(Random& random, std::int64_t size = 9) {
  std::int64_t a = 0, b = 0, c = 0, d = 0;
  while (a == 0 && b == 0 && c == 0 && d == 0) {
    a = random.integer(-size, size);
    b = random.integer(-size, size);
    c = random.integer(-size, size);
    d = random.integer(-size, size);
  }
  PythagoreanRotation r;
  r.denominator = a * a + b * b + c * c + d * d;
  r.numerator = {{{a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
                  {2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)},
                  {2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d}}};
  return r;
}

template <class N>
Matrix4<N> exactly(const PythagoreanRotation& r) {
  Matrix4<N> m = Matrix4<N>::identity();
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) m.at[i][j] = N(r.numerator[i][j]) / N(r.denominator);
  }
  return m;
}

}  // namespace glassbox::exact
