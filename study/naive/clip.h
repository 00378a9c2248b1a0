// Clipping as beginners first write it: Sutherland and Hodgman's algorithm with one error at a
// time.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <glassbox/pipeline/clip.h>

namespace glassbox::study::naive {

using Outline = std::vector<Point<Clip>>;

inline float distance(const ClipPlane& plane, const Point<Clip>& p) {
  return float(plane.a) * p.x + float(plane.b) * p.y + float(plane.c) * p.z + float(plane.d) * p.w +
         float(plane.e);
}

inline Point<Clip> mixed(const Point<Clip>& a, const Point<Clip>& b, float s, float t) {
  return {s * a.x + t * b.x, s * a.y + t * b.y, s * a.z + t * b.z, s * a.w + t * b.w};
}

// Computes where the edge from a to b crosses the plane, as a + t (b - a). The same edge from b to
// a is rounded differently.
inline Point<Clip> from_first_end(const Point<Clip>& a, float d_a, const Point<Clip>& b,
                                  float d_b) {
  const float t = d_a / (d_a - d_b);
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z),
          a.w + t * (b.w - a.w)};
}

// Computes the crossing as (1 - t) a + t b. The error is smaller than that of a + t (b - a), but
// the edge from b to a is still rounded differently.
inline Point<Clip> weighted_by_t(const Point<Clip>& a, float d_a, const Point<Clip>& b, float d_b) {
  const float t = d_a / (d_a - d_b);
  return mixed(a, b, 1 - t, t);
}

using Crossing = Point<Clip> (*)(const Point<Clip>&, float, const Point<Clip>&, float);

struct Clipper {
  Crossing crossing = from_first_end;
  bool on_plane_is_inside = true;
  std::size_t capacity = 64;  // vertices beyond this number are lost
};

inline Outline clip(const Clipper& clipper, const std::array<ClipVertex, 3>& triangle,
                    std::span<const ClipPlane> planes) {
  Outline polygon{triangle[0].position, triangle[1].position, triangle[2].position};
  for (const ClipPlane& plane : planes) {
    Outline kept;
    const auto keep = [&](const Point<Clip>& p) {
      if (kept.size() < clipper.capacity) kept.push_back(p);
    };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point<Clip>&here = polygon[i], &next = polygon[(i + 1) % polygon.size()];
      const float d_here = distance(plane, here), d_next = distance(plane, next);
      const auto inside = [&](float d) { return clipper.on_plane_is_inside ? d >= 0 : d > 0; };
      if (inside(d_here)) keep(here);
      if (inside(d_here) != inside(d_next)) keep(clipper.crossing(here, d_here, next, d_next));
    }
    polygon = kept;
  }
  return polygon;
}

// Does not clip at all: leaves the triangle as it is, to be divided by w.
inline Outline nothing(const std::array<ClipVertex, 3>& triangle, std::span<const ClipPlane>) {
  return {triangle[0].position, triangle[1].position, triangle[2].position};
}

}  // namespace glassbox::study::naive
