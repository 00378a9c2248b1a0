// A camera's view matrix, computed with 50 digits.
#pragma once

#include <glassbox/base/spaces.h>

#include "exact/matrix.h"
#include "exact/number.h"

namespace glassbox::exact {

using DecimalVector = Vector<World, Decimal>;

inline DecimalVector exactly(const Vector<World, double>& v) {
  return {Decimal(v.x), Decimal(v.y), Decimal(v.z)};
}

inline DecimalVector normalised(const DecimalVector& v) {
  const Decimal length = sqrt(dot(v, v));
  return {v.x / length, v.y / length, v.z / length};
}

// The view matrix with the rows U, V, N (S4-02), computed from the given doubles without rounding
// them first. `up` must not be parallel to the direction of view.
inline Matrix4<Decimal> look_at(const Point<World, double>& eye, const Point<World, double>& target,
                                const Vector<World, double>& up) {
  const auto at = [](const Point<World, double>& p) {
    return DecimalVector(Decimal(p.x), Decimal(p.y), Decimal(p.z));
  };
  const DecimalVector n = normalised(at(eye) - at(target));
  const DecimalVector u = normalised(cross(exactly(up), n));
  const DecimalVector v = cross(n, u);
  Matrix4<Decimal> m = Matrix4<Decimal>::identity();
  const DecimalVector rows[] = {u, v, n};
  for (std::size_t i = 0; i < 3; ++i) {
    m.at[i] = {rows[i].x, rows[i].y, rows[i].z, -dot(rows[i], at(eye))};
  }
  return m;
}

// The angle between two directions in radians, computed with 50 digits, so that it is accurate near
// 0 and pi too.
inline double angle(const DecimalVector& a, const DecimalVector& b) {
  const DecimalVector across = cross(a, b);
  return double(atan2(sqrt(dot(across, across)), dot(a, b)));
}

}  // namespace glassbox::exact
