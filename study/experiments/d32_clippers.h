// Two versions of Sutherland and Hodgman's clipping algorithm (D-32): with the planes of the
// viewing pyramid in eye space, and with those of the box in clip space (S3-11). Everything else is
// the same.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glassbox/base/spaces.h>

namespace glassbox::study::d32 {

inline constexpr std::size_t kPlanes = 6;              // order: left, right, bottom, top, near, far
inline constexpr double kWidth = 1024, kHeight = 683;  // in px

// A perspective projection whose entries are floats, so that both spaces have exactly the same
// pyramid.
struct Lens {
  float a = 0, b = 0;           // x' = a x, y' = b y, w = -z
  float depth = 0, offset = 0;  // z' = depth z + offset
  float near = 0, far = 0;
};

// The largest number of corners after clipping. Rounding may bend a sliver so that it crosses a
// plane more than twice. If k of n corners are inside, there are at most 2 min(k, n - k) crossings,
// and clipping leaves at most 3n/2 corners.
constexpr std::size_t most_vertices() {
  std::size_t most = 3;
  for (std::size_t plane = 0; plane < kPlanes; ++plane) most = most * 3 / 2;
  return most;
}
inline constexpr std::size_t kMaxVertices = most_vertices();

// The result of clipping, in clip space.
struct Outline {
  std::array<Point<Clip>, kMaxVertices> vertices;
  // The last plane that created the vertex; -1: a vertex of the original triangle.
  std::array<std::int8_t, kMaxVertices> cut_by{};
  std::size_t count = 0;
};

using EyeTriangle = std::array<Point<Eye>, 3>;

inline Point<Clip> to_clip(const Lens& lens, const Point<Eye>& p) {
  return {lens.a * p.x, lens.b * p.y, lens.depth * p.z + lens.offset, -p.z};
}

// ---- the two spaces ----

struct EyeSpace {
  using Vertex = Point<Eye>;
  Lens lens;

  Vertex from_eye(const Point<Eye>& p) const { return p; }
  Point<Clip> to_clip_point(const Vertex& v) const { return to_clip(lens, v); }
  // The distance from a plane, up to a factor. Each side of the pyramid needs a product and a sum.
  double distance(std::size_t plane, const Vertex& v) const {
    switch (plane) {
      case 0:
        return double(lens.a) * double(v.x) - double(v.z);
      case 1:
        return -double(lens.a) * double(v.x) - double(v.z);
      case 2:
        return double(lens.b) * double(v.y) - double(v.z);
      case 3:
        return -double(lens.b) * double(v.y) - double(v.z);
      case 4:
        return -double(v.z) - double(lens.near);
      default:
        return double(lens.far) + double(v.z);
    }
  }
  // Puts the vertex exactly on the near or the far plane. On the sides of the pyramid x = -+z/a
  // would have to be rounded, so the computed x stays.
  void put_on(std::size_t plane, Vertex& v) const {
    if (plane == 4) v.z = -lens.near;
    if (plane == 5) v.z = -lens.far;
  }
  static Vertex mixed(const Vertex& p, double s, const Vertex& q, double t) {
    return {float(s * double(p.x) + t * double(q.x)), float(s * double(p.y) + t * double(q.y)),
            float(s * double(p.z) + t * double(q.z))};
  }
};

struct ClipSpace {
  using Vertex = Point<Clip>;
  Lens lens;

  Vertex from_eye(const Point<Eye>& p) const { return to_clip(lens, p); }
  Point<Clip> to_clip_point(const Vertex& v) const { return v; }
  // The distance from a plane, up to a factor. It needs one sum, or nothing.
  double distance(std::size_t plane, const Vertex& v) const {
    switch (plane) {
      case 0:
        return double(v.w) + double(v.x);
      case 1:
        return double(v.w) - double(v.x);
      case 2:
        return double(v.w) + double(v.y);
      case 3:
        return double(v.w) - double(v.y);
      case 4:
        return double(v.z);
      default:
        return double(v.w) - double(v.z);
    }
  }
  // Puts the vertex exactly on the plane, for example x = -w.
  void put_on(std::size_t plane, Vertex& v) const {
    if (plane < 2) v.x = plane == 0 ? -v.w : v.w;
    if (plane == 2 || plane == 3) v.y = plane == 2 ? -v.w : v.w;
    if (plane == 4) v.z = 0;
    if (plane == 5) v.z = v.w;
  }
  static Vertex mixed(const Vertex& p, double s, const Vertex& q, double t) {
    return {float(s * double(p.x) + t * double(q.x)), float(s * double(p.y) + t * double(q.y)),
            float(s * double(p.z) + t * double(q.z)), float(s * double(p.w) + t * double(q.w))};
  }
};

// ---- the algorithm ----

template <class Space>
struct Polygon {
  std::array<typename Space::Vertex, kMaxVertices> vertices;
  std::array<std::int8_t, kMaxVertices> cut_by;
  std::size_t count = 0;

  void add(const typename Space::Vertex& v, int plane) {
    vertices[count] = v;
    cut_by[count++] = std::int8_t(plane);
  }
};

// Clips the polygon at one plane. The point where an edge crosses the plane is the same in both
// directions of the edge (B.1): it is computed in double and rounded once.
template <class Space>
Polygon<Space> cut(const Space& space, std::size_t plane, const Polygon<Space>& polygon) {
  std::array<double, kMaxVertices> distances;
  for (std::size_t i = 0; i < polygon.count; ++i)
    distances[i] = space.distance(plane, polygon.vertices[i]);
  Polygon<Space> kept;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const std::size_t next = i + 1 == polygon.count ? 0 : i + 1;
    const double here = distances[i], there = distances[next];
    if (here >= 0) kept.add(polygon.vertices[i], polygon.cut_by[i]);
    if (here * there >= 0) continue;
    const double sum = std::abs(here) + std::abs(there);
    auto v = Space::mixed(polygon.vertices[i], std::abs(there) / sum, polygon.vertices[next],
                          std::abs(here) / sum);
    space.put_on(plane, v);
    kept.add(v, int(plane));
  }
  return kept;
}

// Clips a triangle. Outcodes are tested first, because most triangles are inside all planes or
// completely outside one of them.
template <class Space>
void clip(const Space& space, const EyeTriangle& triangle, Outline& outline) {
  Polygon<Space> polygon;
  unsigned all = ~0u, any = 0;
  for (const Point<Eye>& p : triangle) {
    const auto v = space.from_eye(p);
    unsigned code = 0;
    for (std::size_t plane = 0; plane < kPlanes; ++plane)
      code |= unsigned(space.distance(plane, v) < 0) << plane;
    all &= code;
    any |= code;
    polygon.add(v, -1);
  }
  outline.count = 0;
  if (all != 0) return;
  for (std::size_t plane = 0; plane < kPlanes && any != 0; ++plane) {
    if ((any >> plane & 1) != 0) polygon = cut(space, plane, polygon);
  }
  outline.count = polygon.count;
  outline.cut_by = polygon.cut_by;
  for (std::size_t i = 0; i < polygon.count; ++i)
    outline.vertices[i] = space.to_clip_point(polygon.vertices[i]);
}

// ---- the error ----

// The distance in px between a vertex and the edge of the picture that has cut it.
inline double distance_from_edge(const Point<Clip>& p, int plane) {
  const double along = double(plane < 2 ? p.x : p.y) / double(p.w);
  const double half_side = (plane < 2 ? kWidth : kHeight) / 2;
  return std::abs(std::abs(along) - 1) * half_side;
}

// ---- triangles ----

Lens course_lens();

// Triangles around random places in the picture and slightly outside it, at all depths, with edges
// of about `size` picture widths.
std::vector<EyeTriangle> random_triangles(double size, std::size_t count);

}  // namespace glassbox::study::d32
