// Triangles, views and planes for the clipping tests.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/pipeline/clip.h>

#include "tests/support/catch.h"

namespace glassbox::test {

using Triangle3 = std::array<ClipVertex, 3>;

inline Triangle3 triangle(const Point<Clip>& a, const Point<Clip>& b, const Point<Clip>& c) {
  return {ClipVertex{a, {1, 0, 0}}, ClipVertex{b, {0, 1, 0}}, ClipVertex{c, {0, 0, 1}}};
}

inline Point<Clip> random_position(Random& random, double w_low, double w_high) {
  return {float(random.between(-1.5, 1.5)), float(random.between(-1.5, 1.5)),
          float(random.between(-0.5, 1.5)), float(random.between(w_low, w_high))};
}

// A random float that has any finite bit pattern.
inline float random_bits(Random& random) {
  for (;;) {
    const float x = std::bit_cast<float>(std::uint32_t(random.bits()));
    if (std::isfinite(x)) return x;
  }
}

inline View perspective_view(float width, float height, double near) {
  View view;
  view.viewport = {0, 0, width, height};
  view.near = near;
  return view;
}

inline bool contains(const ClipPolygon& polygon, const Point<Clip>& position) {
  return std::any_of(polygon.vertices.begin(), polygon.vertices.begin() + polygon.count,
                     [&](const ClipVertex& v) { return v.position == position; });
}

inline bool repeats_a_vertex(const ClipPolygon& polygon) {
  for (int i = 0; i < polygon.count; ++i) {
    const std::size_t here = std::size_t(i), next = std::size_t((i + 1) % polygon.count);
    if (polygon.vertices[here].position == polygon.vertices[next].position) return true;
  }
  return false;
}

inline std::string in_words(const Triangle3& t) {
  std::string text;
  for (const ClipVertex& v : t) {
    text += "(" + Catch::Detail::stringify(v.position.x) + ", " +
            Catch::Detail::stringify(v.position.y) + ", " + Catch::Detail::stringify(v.position.z) +
            ", " + Catch::Detail::stringify(v.position.w) + ") ";
  }
  return text;
}

// near, left, right, bottom and top. The far plane is left out: it can meet a triangle at any small
// angle, so it has no useful bound on the area.
inline std::vector<ClipPlane> planes_without_far() {
  std::vector<ClipPlane> planes;
  for (const ClipPlane& plane : frustum_planes()) {
    if (std::string(plane.name) != "far") planes.push_back(plane);
  }
  return planes;
}

}  // namespace glassbox::test
