// Shared code of the clipping cases: the clippers that are tested, and areas in rational numbers.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/pipeline/clip.h>

#include "exact/clip.h"
#include "exact/number.h"
#include "study/naive/clip.h"

namespace glassbox::study {

using ClipTriangle = std::array<ClipVertex, 3>;
using Outline = naive::Outline;
using ClipFunction = Outline (*)(const ClipTriangle&, std::span<const ClipPlane>);

inline ClipTriangle clip_corners(const Point<Clip>& a, const Point<Clip>& b, const Point<Clip>& c) {
  return {ClipVertex{a, {1, 0, 0}}, ClipVertex{b, {0, 1, 0}}, ClipVertex{c, {0, 0, 1}}};
}

inline Point<Clip> random_position(Random& random, double w_low, double w_high) {
  const double x = random.between(-1.5, 1.5), y = random.between(-1.5, 1.5);
  const double z = random.between(-0.5, 1.5);
  return {float(x), float(y), float(z), float(random.between(w_low, w_high))};
}

inline Outline pipeline_clips(const ClipTriangle& triangle, std::span<const ClipPlane> planes) {
  const ClipPolygon polygon = clip_triangle(triangle, planes);
  Outline outline;
  for (int i = 0; i < polygon.count; ++i) {
    outline.push_back(polygon.vertices[std::size_t(i)].position);
  }
  return outline;
}

inline exact::ExactPolygon<exact::Rational> exact_outline(const Outline& outline) {
  exact::ExactPolygon<exact::Rational> exact;
  for (const Point<Clip>& p : outline) exact.push_back(exact::exact_point<exact::Rational>(p));
  return exact;
}

// The absolute difference of twice the outline's area and twice the exact area, in square NDC
// units; infinite if a w is zero.
double area_error(const Outline& outline, const ClipTriangle& triangle,
                  std::span<const ClipPlane> planes);

// The planes near, left, right, bottom and top. The far plane is left out: it can cut a triangle at
// an arbitrarily small angle, and then the area has no useful bound.
inline std::vector<ClipPlane> planes_without_far() {
  const auto planes = frustum_planes();
  return {planes[0], planes[2], planes[3], planes[4], planes[5]};
}

}  // namespace glassbox::study
