// The teapot's exact surface: Bezier patches evaluated by de Casteljau's construction, in double.
#pragma once

#include <array>
#include <cmath>

#include <glassbox/mesh/builtin/teapot_data.h>

#include <glm/vec3.hpp>

namespace glassbox::study {

using Curve = std::array<glm::dvec3, 4>;

// Position, first and second derivative of a cubic.
struct CurvePoint {
  glm::dvec3 at, along, bend;
};

inline CurvePoint de_casteljau(const Curve& p, double t) {
  const auto between = [t](const glm::dvec3& a, const glm::dvec3& b) { return a + (b - a) * t; };
  const std::array<glm::dvec3, 3> q{between(p[0], p[1]), between(p[1], p[2]), between(p[2], p[3])};
  const std::array<glm::dvec3, 2> r{between(q[0], q[1]), between(q[1], q[2])};
  return {between(r[0], r[1]), 3.0 * (r[1] - r[0]), 6.0 * (q[2] - 2.0 * q[1] + q[0])};
}

struct SurfacePoint {
  glm::dvec3 at, du, dv, duu, duv, dvv;
  glm::dvec3 normal() const { return glm::cross(du, dv); }  // not of unit length; 0 at a pole
};

class Surface {
public:
  explicit Surface(std::size_t patch) {
    for (std::size_t i = 0; i < 16; ++i) {
      const auto& p = kTeapotPoints[kTeapotPatches[patch][i]];
      rows_[i / 4][i % 4] = {p[0], p[2], -p[1]};  // from z up to y up
    }
  }

  SurfacePoint at(double u, double v) const {
    Curve across, along, bend;  // points and derivatives of all rows at u
    for (std::size_t row = 0; row < 4; ++row) {
      const CurvePoint p = de_casteljau(rows_[row], u);
      across[row] = p.at, along[row] = p.along, bend[row] = p.bend;
    }
    const CurvePoint position = de_casteljau(across, v), du = de_casteljau(along, v);
    return {position.at, du.at, position.along, de_casteljau(bend, v).at, du.along, position.bend};
  }

private:
  std::array<Curve, 4> rows_;
};

}  // namespace glassbox::study
