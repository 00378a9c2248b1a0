// Clips polygons in exact arithmetic: the reference that the clipper's rounded results are compared
// with.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <glassbox/pipeline/clip.h>

namespace glassbox::exact {

template <class N>
struct ExactPoint {
  N x, y, z, w;
};
template <class N>
using ExactPolygon = std::vector<ExactPoint<N>>;

template <class N>
ExactPoint<N> exact_point(const Point<Clip>& p) {
  return {N(double(p.x)), N(double(p.y)), N(double(p.z)), N(double(p.w))};
}

template <class N>
ExactPolygon<N> exact_polygon(const ClipPolygon& polygon) {
  ExactPolygon<N> exact;
  for (int i = 0; i < polygon.count; ++i) {
    exact.push_back(exact_point<N>(polygon.vertices[std::size_t(i)].position));
  }
  return exact;
}

template <class N>
ExactPolygon<N> exact_polygon(const std::array<ClipVertex, 3>& triangle) {
  return {exact_point<N>(triangle[0].position), exact_point<N>(triangle[1].position),
          exact_point<N>(triangle[2].position)};
}

template <class N>
N distance(const ClipPlane& plane, const ExactPoint<N>& p) {
  return N(plane.a) * p.x + N(plane.b) * p.y + N(plane.c) * p.z + N(plane.d) * p.w + N(plane.e);
}

template <class N>
ExactPolygon<N> clip(ExactPolygon<N> polygon, std::span<const ClipPlane> planes) {
  for (const ClipPlane& plane : planes) {
    ExactPolygon<N> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const ExactPoint<N>&p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      const N d_p = distance(plane, p), d_q = distance(plane, q);
      if (d_p >= 0) kept.push_back(p);
      if (d_p.sign() * d_q.sign() >= 0) continue;
      const N t = d_p / (d_p - d_q);
      kept.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), p.z + t * (q.z - p.z),
                      p.w + t * (q.w - p.w)});
    }
    polygon = std::move(kept);
  }
  return polygon;
}

// Twice the signed area of the polygon after the division by w. No w may be zero.
template <class N>
N twice_ndc_area(const ExactPolygon<N>& polygon) {
  N sum = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const ExactPoint<N>&a = polygon[0], &b = polygon[i - 1], &c = polygon[i];
    const N determinant = a.x * (b.y * c.w - b.w * c.y) - a.y * (b.x * c.w - b.w * c.x) +
                          a.w * (b.x * c.y - b.y * c.x);
    sum += determinant / (a.w * b.w * c.w);
  }
  return sum;
}

}  // namespace glassbox::exact
