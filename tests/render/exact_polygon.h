// The polygon that clipping leaves of a triangle, computed in arithmetic of 320 bits from the
// matrices.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <vector>

#include <glassbox/pipeline/clip.h>
#include <glassbox/render/trace/records.h>

namespace glassbox::test {

// Products of four doubles and some sums are exact in this type, or nearly so: its rounding is
// 2^-250 of any bound.
using Big = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<320, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

using BigVector = std::array<Big, 4>;
using BigMatrix = std::array<BigVector, 4>;  // [row][column]

inline BigMatrix exactly(const glm::dmat4& m) {
  BigMatrix exact;
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column)
      exact[row][column] = m[int(column)][int(row)];
  }
  return exact;
}

inline BigMatrix operator*(const BigMatrix& a, const BigMatrix& b) {
  BigMatrix product;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 4; ++k) product[i][j] += a[i][k] * b[k][j];
    }
  }
  return product;
}

inline BigVector operator*(const BigMatrix& m, const Point<Object>& p) {
  BigVector product;
  for (std::size_t i = 0; i < 4; ++i) {
    product[i] = m[i][0] * Big(p.x) + m[i][1] * Big(p.y) + m[i][2] * Big(p.z) + m[i][3];
  }
  return product;
}

struct ExactVertex {
  BigVector clip;
  std::array<Big, 3> weights;
};

inline Big distance_from(const ClipPlane& plane, const BigVector& p) {
  return Big(plane.a) * p[0] + Big(plane.b) * p[1] + Big(plane.c) * p[2] + Big(plane.d) * p[3] +
         Big(plane.e);
}

inline ExactVertex exact_crossing(const ClipPlane& plane, const ExactVertex& p,
                                  const ExactVertex& q) {
  const Big dp = distance_from(plane, p.clip), dq = distance_from(plane, q.clip);
  const Big s = dp / (dp - dq);
  ExactVertex cut;
  for (std::size_t i = 0; i < 4; ++i) cut.clip[i] = p.clip[i] + s * (q.clip[i] - p.clip[i]);
  for (std::size_t i = 0; i < 3; ++i)
    cut.weights[i] = p.weights[i] + s * (q.weights[i] - p.weights[i]);
  return cut;
}

// The polygon that is left, cut exactly along the edges that the run has cut; in the order of
// TracedTriangle::polygon.
inline std::vector<ExactVertex> exact_polygon(const Trace& trace, const TracedTriangle& triangle,
                                              const std::array<BigVector, 3>& corners) {
  std::vector<ExactVertex> polygon;
  for (std::size_t k = 0; k < 3; ++k) {
    polygon.push_back({corners[k], {}});
    polygon.back().weights[k] = 1;
  }
  for (std::size_t i = 0; i < triangle.clipping.size(); ++i) {
    const ClipStep& step = triangle.clipping[i];
    std::vector<ExactVertex> after;
    for (int j = 0; j < step.after.count; ++j) {
      const auto [from, to] = step.sources[std::size_t(j)];
      const ExactVertex& p = polygon[std::size_t(from)];
      after.push_back(from == to ? p
                                 : exact_crossing(trace.planes[i], p, polygon[std::size_t(to)]));
    }
    polygon = after;
  }
  if (triangle.clipping.empty()) return polygon;
  const ClipPolygon& last = triangle.clipping.back().after;
  std::vector<ExactVertex> kept;
  for (int i = 0; i < last.count && kept.size() < triangle.polygon.size(); ++i) {
    if (last.vertices[std::size_t(i)].position == triangle.polygon[kept.size()].clip.position) {
      kept.push_back(polygon[std::size_t(i)]);
    }
  }
  return kept;
}

}  // namespace glassbox::test
