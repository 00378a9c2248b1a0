// Clip space in rational arithmetic: the oracle for clipping.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <span>
#include <vector>

#include <glassbox/pipeline/clip.h>

namespace glassbox::test {

using Rational = boost::multiprecision::cpp_rational;

struct RationalPoint {
  Rational x, y, z, w;
};
using RationalPolygon = std::vector<RationalPoint>;

inline RationalPoint exactly(const Point<Clip>& p) {
  return {Rational(p.x), Rational(p.y), Rational(p.z), Rational(p.w)};
}

inline RationalPolygon exactly(const ClipPolygon& polygon) {
  RationalPolygon exact;
  for (int i = 0; i < polygon.count; ++i) {
    exact.push_back(exactly(polygon.vertices[std::size_t(i)].position));
  }
  return exact;
}

inline RationalPolygon exactly(const std::array<ClipVertex, 3>& triangle) {
  return {exactly(triangle[0].position), exactly(triangle[1].position),
          exactly(triangle[2].position)};
}

inline Rational distance(const ClipPlane& plane, const RationalPoint& p) {
  return Rational(plane.a) * p.x + Rational(plane.b) * p.y + Rational(plane.c) * p.z +
         Rational(plane.d) * p.w + Rational(plane.e);
}

inline RationalPolygon clip(RationalPolygon polygon, std::span<const ClipPlane> planes) {
  for (const ClipPlane& plane : planes) {
    RationalPolygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const RationalPoint &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      const Rational d_p = distance(plane, p), d_q = distance(plane, q);
      if (d_p >= 0) kept.push_back(p);
      if (d_p.sign() * d_q.sign() >= 0) continue;
      const Rational t = d_p / (d_p - d_q);
      kept.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), p.z + t * (q.z - p.z),
                      p.w + t * (q.w - p.w)});
    }
    polygon = std::move(kept);
  }
  return polygon;
}

// Twice the signed area after the divide. All w are non-zero.
inline Rational twice_ndc_area(const RationalPolygon& polygon) {
  Rational sum = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const RationalPoint &a = polygon[0], &b = polygon[i - 1], &c = polygon[i];
    const Rational determinant = a.x * (b.y * c.w - b.w * c.y) - a.y * (b.x * c.w - b.w * c.x) +
                                 a.w * (b.x * c.y - b.y * c.x);
    sum += determinant / (a.w * b.w * c.w);
  }
  return sum;
}

}  // namespace glassbox::test
