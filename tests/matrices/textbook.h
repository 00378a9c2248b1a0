// Matrices as the manuals of the graphics interfaces print them, independent of the program's own
// code: gluLookAt, gluPerspective, glFrustum, glOrtho, D3DXMatrixLookAtLH,
// D3DXMatrixPerspectiveFovLH and RH, D3DXMatrixOrthoOffCenterLH, and their variants in Vulkan
// tutorials. They are the rows of M in p' = M p; the D3DX manual documents the transposes.
#pragma once

#include <array>
#include <cmath>

#include <glassbox/base/random.h>
#include <glassbox/matrices/matrix_facts.h>

namespace glassbox::test::textbook {

using Vector3 = std::array<double, 3>;
using Rows = std::array<std::array<double, 4>, 4>;

inline Vector3 minus(const Vector3& a, const Vector3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline double dot(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Vector3 unit(const Vector3& a) {
  const double length = std::sqrt(dot(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}
inline Rows from_axes(const Vector3& x, const Vector3& y, const Vector3& z, const Vector3& eye) {
  return {{{x[0], x[1], x[2], -dot(x, eye)},
           {y[0], y[1], y[2], -dot(y, eye)},
           {z[0], z[1], z[2], -dot(z, eye)},
           {0, 0, 0, 1}}};
}

// gluLookAt: the eye looks down -z.
inline Rows look_at_right(const Vector3& eye, const Vector3& centre, const Vector3& up) {
  const Vector3 f = unit(minus(centre, eye)), s = unit(cross(f, up)), u = cross(s, f);
  return from_axes(s, u, {-f[0], -f[1], -f[2]}, eye);
}
// D3DXMatrixLookAtLH: the eye looks down +z.
inline Rows look_at_left(const Vector3& eye, const Vector3& at, const Vector3& up) {
  const Vector3 z = unit(minus(at, eye)), x = unit(cross(up, z)), y = cross(z, x);
  return from_axes(x, y, z, eye);
}

inline double radians(double degrees) {
  return degrees * 3.14159265358979323846 / 180;
}

// gluPerspective.
inline Rows perspective_gl(double fovy_radians, double aspect, double n, double f) {
  const double cot = 1 / std::tan(fovy_radians / 2);
  return {{{cot / aspect, 0, 0, 0},
           {0, cot, 0, 0},
           {0, 0, (f + n) / (n - f), 2 * f * n / (n - f)},
           {0, 0, -1, 0}}};
}
// D3DXMatrixPerspectiveFovRH.
inline Rows perspective_d3d_right(double fovy_radians, double aspect, double n, double f) {
  const double scale = 1 / std::tan(fovy_radians / 2);
  return {{{scale / aspect, 0, 0, 0},
           {0, scale, 0, 0},
           {0, 0, f / (n - f), n * f / (n - f)},
           {0, 0, -1, 0}}};
}
// D3DXMatrixPerspectiveFovLH.
inline Rows perspective_d3d_left(double fovy_radians, double aspect, double n, double f) {
  const double scale = 1 / std::tan(fovy_radians / 2);
  return {{{scale / aspect, 0, 0, 0},
           {0, scale, 0, 0},
           {0, 0, f / (f - n), -n * f / (f - n)},
           {0, 0, 1, 0}}};
}
// GLM with depth from 0 to 1 and proj[1][1] *= -1.
inline Rows perspective_vulkan(double fovy_radians, double aspect, double n, double f) {
  Rows m = perspective_d3d_right(fovy_radians, aspect, n, f);
  m[1][1] *= -1;
  return m;
}
// Depth is 1 at the near plane and 0 at infinity.
inline Rows perspective_reversed_infinite(double fovy_radians, double aspect, double n) {
  const double scale = 1 / std::tan(fovy_radians / 2);
  return {{{scale / aspect, 0, 0, 0}, {0, scale, 0, 0}, {0, 0, 0, n}, {0, 0, -1, 0}}};
}
// glFrustum.
inline Rows frustum_gl(double l, double r, double b, double t, double n, double f) {
  return {{{2 * n / (r - l), 0, (r + l) / (r - l), 0},
           {0, 2 * n / (t - b), (t + b) / (t - b), 0},
           {0, 0, -(f + n) / (f - n), -2 * f * n / (f - n)},
           {0, 0, -1, 0}}};
}
// glOrtho.
inline Rows ortho_gl(double l, double r, double b, double t, double n, double f) {
  return {{{2 / (r - l), 0, 0, -(r + l) / (r - l)},
           {0, 2 / (t - b), 0, -(t + b) / (t - b)},
           {0, 0, -2 / (f - n), -(f + n) / (f - n)},
           {0, 0, 0, 1}}};
}
// D3DXMatrixOrthoOffCenterLH, or RH if not `left`.
inline Rows ortho_d3d(double l, double r, double b, double t, double n, double f, bool left) {
  const double sign = left ? 1 : -1;
  return {{{2 / (r - l), 0, 0, (l + r) / (l - r)},
           {0, 2 / (t - b), 0, (t + b) / (b - t)},
           {0, 0, sign / (f - n), n / (n - f)},
           {0, 0, 0, 1}}};
}
inline Rows ortho_vulkan(double l, double r, double b, double t, double n, double f) {
  Rows m = ortho_d3d(l, r, b, t, n, f, false);
  for (double& entry : m[1]) entry = -entry;
  return m;
}

inline Rows identity() {
  return {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
}
inline Rows translation(double x, double y, double z) {
  return {{{1, 0, 0, x}, {0, 1, 0, y}, {0, 0, 1, z}, {0, 0, 0, 1}}};
}
inline Rows scaling(double x, double y, double z) {
  return {{{x, 0, 0, 0}, {0, y, 0, 0}, {0, 0, z, 0}, {0, 0, 0, 1}}};
}
// Rotates about y, counter-clockwise seen from above.
inline Rows turn_y(double degrees) {
  const double c = std::cos(radians(degrees)), s = std::sin(radians(degrees));
  return {{{c, 0, s, 0}, {0, 1, 0, 0}, {-s, 0, c, 0}, {0, 0, 0, 1}}};
}
inline Rows turn_x(double degrees) {
  const double c = std::cos(radians(degrees)), s = std::sin(radians(degrees));
  return {{{1, 0, 0, 0}, {0, c, -s, 0}, {0, s, c, 0}, {0, 0, 0, 1}}};
}

inline Rows product(const Rows& a, const Rows& b) {
  Rows c{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 4; ++k) c[i][j] += a[i][k] * b[k][j];
    }
  }
  return c;
}
inline Rows transposed(const Rows& a) {
  Rows c{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) c[i][j] = a[j][i];
  }
  return c;
}
// The inverse of a rotation and a translation.
inline Rows rigid_inverse(const Rows& a) {
  Rows c = identity();
  for (std::size_t i = 0; i < 3; ++i) {
    c[i][3] = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      c[i][j] = a[j][i];
      c[i][3] -= a[j][i] * a[j][3];
    }
  }
  return c;
}

inline Vector3 random_place(Random& random, double size) {
  return {random.between(-size, size), random.between(-size, size), random.between(-size, size)};
}

// Rounds the entries to float, as a program with float matrices has them.
inline GivenMatrix given(const Rows& rows) {
  GivenMatrix matrix;
  matrix.given = true;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      const float entry = float(rows[std::size_t(row)][std::size_t(column)]);
      matrix.m[column][row] = double(entry);
      matrix.uncertainty[column][row] = std::abs(double(entry)) * 0x1p-24;
    }
  }
  return matrix;
}

}  // namespace glassbox::test::textbook
