// Wrong ways to compute depth over a triangle and to convert it for the depth buffer.
#pragma once

#include <cstdint>

#include <glassbox/raster/coverage.h>
#include <glassbox/raster/stages.h>

namespace glassbox::study::naive {

// The change of depth per pixel along x and along y, computed in float from the edge functions and
// the area.
struct Gradient {
  float x = 0, y = 0;
};
inline Gradient depth_gradient(const TriangleSetup& t) {
  Gradient g;
  for (std::size_t k = 0; k < 3; ++k) {
    g.x += float(t.edges[k].a) * 256.0f / float(t.double_area) * t.depth[k];
    g.y += float(t.edges[k].b) * 256.0f / float(t.double_area) * t.depth[k];
  }
  return g;
}

// Computes depth from the plane equation d = A x + B y + C. C is a small difference of large
// numbers, and it is rounded differently in different triangles of the same plane.
inline float plane_depth(const TriangleSetup& t, const Coverage& pixel) {
  const Gradient g = depth_gradient(t);
  float c = 0;
  for (std::size_t k = 0; k < 3; ++k) c += float(t.edges[k].c) / float(t.double_area) * t.depth[k];
  return g.x * (float(pixel.x) + 0.5f) + g.y * (float(pixel.y) + 0.5f) + c;
}

// Computes depth as d0 + A (x - x0) + B (y - y0), where (x0, y0) is the corner pixel of the
// triangle's bounding box and d0 the depth there. That pixel may be outside the triangle, where the
// depth may have any value.
inline float depth_from_corner(const TriangleSetup& t, const Coverage& pixel) {
  const Gradient g = depth_gradient(t);
  const std::int64_t x = std::int64_t(t.bounds.x0) * 256 + 128;
  const std::int64_t y = std::int64_t(t.bounds.y0) * 256 + 128;
  float corner = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    corner += float(t.edges[k].at(x, y)) / float(t.double_area) * t.depth[k];
  }
  return corner + g.x * float(pixel.x - t.bounds.x0) + g.y * float(pixel.y - t.bounds.y0);
}

// Adds weights times depths in the order in which the vertices are given: if the same triangle is
// given with another first vertex, its depths change by an ulp.
inline float depth_in_given_order(const TriangleSetup& t, const Coverage& pixel) {
  std::array<float, 3> term{};
  for (std::size_t k = 0; k < 3; ++k) {
    term[std::size_t(t.order[k])] = float(pixel.edges[k]) * t.inverse_area * t.depth[k];
  }
  return term[0] + term[1] + term[2];
}

inline bool in_front_or_equal(std::uint32_t incoming, std::uint32_t stored) {
  return incoming <= stored;
}

// ---- 24 bits ----

// Depth 1.0 becomes 2^24, whose lowest 24 bits are 0: the far plane gets the code of the nearest
// depth.
inline std::uint32_t unorm24_wrapping(float z) {
  return std::uint32_t(double(z) * 0x1p24) & 0xffffffu;
}
inline std::uint32_t unorm24_truncating(float z) {
  return std::uint32_t(double(z) * 16777215.0);
}
// Rounds by adding a half, but the float sum is itself rounded to 24 bits.
inline std::uint32_t unorm24_in_float(float z) {
  return std::uint32_t(z * 16777215.0f + 0.5f);
}

}  // namespace glassbox::study::naive
