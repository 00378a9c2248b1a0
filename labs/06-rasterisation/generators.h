// The generated inputs of lab 6: 100,000 for each function, of all kinds that student.h names and
// of the borders between them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "cases.h"
#include "labs/framework/bezout.h"
#include "labs/framework/choices.h"

namespace lab_06 {
// A namespace of its own: a function or type of yours in student.cpp may have the name of one of
// these, and does not replace it.
inline namespace inputs {

using glassbox::labs::Choices;
using glassbox::labs::InputClass;

inline constexpr std::int32_t kLargest = (1 << 24) - 1;  // steps: the largest position

// ---- positions (task 6.1) ----

inline SnapCase one_position(double pixels) {
  // The conversion rounds to the nearest float, which could be 2^16 without the clamp.
  constexpr double kMost = 0x1p16 - 0x1p-8;  // the largest float below
  return {"a position", {float(std::clamp(pixels, -kMost, kMost))}};
}

inline std::vector<InputClass<SnapCase>> generated_positions() {
  return {
      {"positions of every size", 40'000, [](Choices& c) { return one_position(c.real(-20, 15)); }},
      {"halves of a step, and the floats beside them", 40'000,
       [](Choices& c) {
         // 2^24 numbers of half steps fit a float exactly.
         const double half = double(2 * c.sized(22) + 1) / 512;
         return one_position(double(c.near(float(half))));
       }},
      {"whole steps, and the floats beside them", 10'000,
       [](Choices& c) { return one_position(double(c.near(float(c.sized(23)) / 256))); }},
      {"positions near 0, down to the smallest float", 10'000, [](Choices& c) {
         return one_position(c.flag() ? c.real(-149, -9) : c.one_of({0.0, -0.0}));
       }}};
}

// ---- vertices ----

// A position on one axis, of any size up to the largest.
inline std::int32_t any_position(Choices& c) {
  return std::int32_t(std::clamp<std::int64_t>(c.sized(24), -kLargest, kLargest));
}
inline SnappedVertex any_vertex(Choices& c) {
  const std::int32_t x = any_position(c);
  return {x, any_position(c)};
}
inline SnappedVertex vertex_within(Choices& c, std::int32_t reach) {
  const auto x = std::int32_t(c.integer(-reach, reach));
  return {x, std::int32_t(c.integer(-reach, reach))};
}
inline SnappedVertex moved(const SnappedVertex& v, std::int64_t x, std::int64_t y) {
  const auto inside = [](std::int64_t at) {
    return std::int32_t(std::clamp<std::int64_t>(at, -kLargest, kLargest));
  };
  return {inside(v.x + x), inside(v.y + y)};
}
// A vertex up to `reach` steps away along each axis.
inline SnappedVertex moved_by_up_to(Choices& c, const SnappedVertex& v, std::int64_t reach) {
  const std::int64_t x = c.integer(-reach, reach);
  return moved(v, x, c.integer(-reach, reach));
}
// A vertex next to another one, on the same row or column, or anywhere.
inline SnappedVertex vertex_beside(Choices& c, const SnappedVertex& v) {
  switch (c.below(4)) {
    case 0:
      return {any_position(c), v.y};
    case 1:
      return {v.x, any_position(c)};
    case 2:
      return moved_by_up_to(c, v, 2);
    default:
      return any_vertex(c);
  }
}

// ---- edges (tasks 6.2 and 6.3) ----

inline EdgeCase one_edge(const SnappedVertex& a, const SnappedVertex& b, const SnappedVertex& p) {
  return {"an edge", {Triangle{a, b, p}}};
}

// A vector of any size, and the point nearest to its line that is not on it.
struct VectorAndPoint {
  SnappedVertex d, p;  // d x p is the greatest common divisor of d.x and d.y (or its negative)
};
inline VectorAndPoint vector_and_point(Choices& c) {
  const SnappedVertex d = any_vertex(c);
  const auto [u, v] = glassbox::labs::bezout(d.x, d.y);
  return {d, {std::int32_t(-v), std::int32_t(u)}};
}

// An edge of any length that passes the point as closely as the grid allows, or through it.
struct Edge {
  SnappedVertex a, b;
};
inline Edge edge_beside(Choices& c, const SnappedVertex& point) {
  const auto [d, p] = vector_and_point(c);
  const std::int64_t off = c.integer(-2, 2);
  // From a to the point: off p, or off p + d if the point would be behind a.
  const bool behind = off * (std::int64_t(d.x) * p.x + std::int64_t(d.y) * p.y) < 0;
  const SnappedVertex a =
      moved(point, -off * p.x - (behind ? d.x : 0), -off * p.y - (behind ? d.y : 0));
  return {a, moved(a, d.x, d.y)};
}

// Points on an edge or a few steps beside it: the edge is `steps` times a small vector.
inline EdgeCase point_on_edge(Choices& c) {
  const SnappedVertex small = vertex_within(c, 64);
  const std::int64_t steps = c.integer(1, 100'000);
  const SnappedVertex a = vertex_within(c, kLargest / 2);
  const SnappedVertex b = moved(a, small.x * steps, small.y * steps);
  const std::int64_t along = c.integer(-2, steps + 2);
  return one_edge(a, b, moved_by_up_to(c, moved(a, small.x * along, small.y * along), 1));
}

inline EdgeCase point_beside_edge(Choices& c) {
  const SnappedVertex p = any_vertex(c);
  const Edge edge = edge_beside(c, p);
  return one_edge(edge.a, edge.b, p);
}

// Three corners of the whole range, each moved by a few steps: the largest products.
inline SnappedVertex far_corner(Choices& c) {
  const auto coordinate = [&c] {
    const std::int32_t sign = c.flag() ? -1 : 1;
    return sign * (kLargest - std::int32_t(c.below(4)));
  };
  const std::int32_t x = coordinate();
  return {x, coordinate()};
}

inline std::vector<InputClass<EdgeCase>> generated_edges() {
  return {{"edges and points of every size", 40'000,
           [](Choices& c) {
             const SnappedVertex a = any_vertex(c), b = any_vertex(c);
             return one_edge(a, b, any_vertex(c));
           }},
          {"points on edges and a step beside them", 20'000, point_on_edge},
          {"points as near to an edge as the grid allows", 20'000, point_beside_edge},
          {"edges across the whole range", 20'000, [](Choices& c) {
             const SnappedVertex a = far_corner(c), b = far_corner(c);
             return one_edge(a, b, far_corner(c));
           }}};
}

inline std::vector<InputClass<EdgeCase>> generated_directions() {
  return {{"directions of every kind, exactly along the axes and a step beside", 100'000,
           [](Choices& c) {
             const SnappedVertex a = any_vertex(c);
             SnappedVertex b = vertex_beside(c, a);
             if (b == a) b = moved(a, a.x > 0 ? -1 : 1, 0);
             return one_edge(a, b, {});
           }}};
}

// ---- triangles (task 6.4) ----

// A window of at most 8 x 8 pixels around a position.
inline PixelRect window_around(Choices& c, const SnappedVertex& v) {
  const int x = (v.x >> 8) - int(c.below(8)), y = (v.y >> 8) - int(c.below(8));
  const int width = 1 + int(c.below(8));
  return {x, y, x + width, y + 1 + int(c.below(8))};
}

inline CoverageCase one_triangle(const Triangle& t, const PixelRect& window) {
  return {"a triangle", {t}, window};
}

// Corners in steps of half a pixel: on centres, on corners and edges of pixels.
inline CoverageCase triangle_on_centres(Choices& c) {
  Triangle t;
  for (SnappedVertex& v : t) {
    const auto x = std::int32_t(c.integer(-6, 12)) * kCentre;
    v = {x, std::int32_t(c.integer(-6, 12)) * kCentre};
  }
  return one_triangle(t, window_around(c, t[0]));
}

inline CoverageCase small_triangle(Choices& c) {
  const SnappedVertex a = vertex_within(c, 2000);
  const SnappedVertex b = vertex_beside(c, a);
  const SnappedVertex third = moved_by_up_to(c, a, 2000);
  return one_triangle({a, b, third}, window_around(c, a));
}

// The point at a fraction t of an edge, rounded down to a step.
inline SnappedVertex along(const SnappedVertex& a, const SnappedVertex& b, std::int64_t t,
                           std::int64_t of) {
  return {std::int32_t(a.x + (std::int64_t(b.x) - a.x) * t / of),
          std::int32_t(a.y + (std::int64_t(b.y) - a.y) * t / of)};
}

// A triangle of any size, seen where one of its edges passes.
inline CoverageCase window_at_edge(Choices& c) {
  Triangle t;
  for (SnappedVertex& v : t) v = any_vertex(c);
  const std::size_t k = c.below(3);
  const SnappedVertex passed = along(t[k], t[(k + 1) % 3], c.integer(0, 1 << 20), 1 << 20);
  return one_triangle(t, window_around(c, passed));
}

inline SnappedVertex any_centre(Choices& c) {
  const auto x = std::int32_t(c.integer(-30'000, 30'000)) * kSteps + kCentre;
  return {x, std::int32_t(c.integer(-30'000, 30'000)) * kSteps + kCentre};
}

// A large triangle with an edge that passes exactly through the centre of a pixel: both ends are
// moved from the centre by multiples of the same small vector.
inline CoverageCase edge_through_centre(Choices& c) {
  const SnappedVertex centre = any_centre(c);
  const SnappedVertex d = vertex_within(c, 300);
  const std::int64_t forth = c.integer(1, 25'000), back = c.integer(1, 25'000);
  const SnappedVertex a = moved(centre, d.x * forth, d.y * forth),
                      b = moved(centre, -d.x * back, -d.y * back);
  const SnappedVertex third = any_vertex(c);
  return one_triangle({a, b, third}, window_around(c, centre));
}

// A triangle of any size with an edge that passes a centre as closely as the grid allows.
inline CoverageCase edge_beside_centre(Choices& c) {
  const SnappedVertex centre = any_centre(c);
  const Edge edge = edge_beside(c, centre);
  const SnappedVertex third = any_vertex(c);
  return one_triangle({edge.a, edge.b, third}, window_around(c, centre));
}

// A thin triangle: its corners are near a line.
inline CoverageCase sliver(Choices& c) {
  const SnappedVertex a = vertex_within(c, 4000), b = vertex_within(c, 4000);
  const SnappedVertex p = along(a, b, c.integer(-4, 8), 4);
  const SnappedVertex third = moved_by_up_to(c, p, 3), seen = along(a, b, c.integer(0, 4), 4);
  return one_triangle({a, b, third}, window_around(c, seen));
}

// A triangle as small as its longest edge allows, with a corner on a centre.
inline CoverageCase smallest_triangle(Choices& c) {
  const SnappedVertex centre = any_centre(c);
  const auto [d, p] = vector_and_point(c);
  Triangle t{centre, moved(centre, d.x, d.y), moved(centre, p.x, p.y)};
  if (c.flag()) std::swap(t[1], t[2]);
  return one_triangle(t, window_around(c, centre));
}

inline std::vector<InputClass<CoverageCase>> generated_triangles() {
  return {{"triangles with corners on centres, corners and edges of pixels", 20'000,
           triangle_on_centres},
          {"small triangles", 20'000, small_triangle},
          {"triangles up to 2^16 pixels, where an edge passes (C-50)", 15'000, window_at_edge},
          {"large triangles with an edge through a centre (C-45)", 15'000, edge_through_centre},
          {"large triangles whose edge passes a centre by less than a step (C-45)", 10'000,
           edge_beside_centre},
          {"slivers, some without area (C-47)", 10'000, sliver},
          {"the smallest triangles with a corner on a centre (C-47)", 10'000, smallest_triangle}};
}

// ---- polygons (task 6.5) ----

inline PolygonsCase one_polygon(std::vector<SnappedVertex> polygon) {
  return {"a polygon", {std::move(polygon)}};
}

inline PolygonsCase any_polygon(Choices& c, std::int32_t reach) {
  std::vector<SnappedVertex> polygon(3 + c.below(5));
  for (SnappedVertex& v : polygon) v = vertex_within(c, reach);
  return one_polygon(polygon);
}

// Points on a line of any length and a step beside it, there and back again: what the snap leaves
// of a thin polygon.
inline PolygonsCase thin_polygon(Choices& c) {
  const std::int32_t reach = std::int32_t(1) << c.below(23);
  const SnappedVertex a = vertex_within(c, kLargest / 2), d = vertex_within(c, reach);
  const std::int64_t count = c.integer(2, 4);
  std::vector<SnappedVertex> polygon;
  const auto add = [&](std::int64_t i, std::int64_t off) {
    polygon.push_back(moved_by_up_to(c, moved(a, d.x * i / 4, d.y * i / 4), off));
  };
  for (std::int64_t i = 0; i < count; ++i) add(i, 1);
  for (std::int64_t i = count - 1; i > 0; --i) add(i, 2);
  return one_polygon(polygon);
}

inline std::vector<InputClass<PolygonsCase>> generated_polygons() {
  return {{"small polygons of any shape", 40'000, [](Choices& c) { return any_polygon(c, 3); }},
          {"polygons of every size", 30'000,
           [](Choices& c) { return any_polygon(c, std::int32_t(1) << c.below(24)); }},
          {"thin polygons that the snap has bent", 30'000, thin_polygon}};
}

// ---- tiles (task 6.6) ----

inline TileCase one_tile(const Triangle& t, const PixelRect& tile) {
  return {"a tile", t, {tile}};
}

// Gives a triangle without area an area.
inline Triangle with_area(Triangle t) {
  const auto doubled = (std::int64_t(t[1].x) - t[0].x) * (t[2].y - t[0].y) -
                       (std::int64_t(t[1].y) - t[0].y) * (t[2].x - t[0].x);
  if (doubled == 0)
    t = {t[0], moved(t[0], t[0].x > 0 ? -300 : 300, 0), moved(t[0], 0, t[0].y > 0 ? -300 : 300)};
  return t;
}

inline TileCase tile_of(const CoverageCase& input) {
  return one_tile(with_area(input.triangles[0]), input.window);
}

// An edge that passes within a step of one of the tile's corner centres.
inline TileCase edge_at_corner(Choices& c) {
  const int width = 1 + int(c.below(16)), height = 1 + int(c.below(16));
  const bool right = c.flag(), bottom = c.flag();
  const SnappedVertex corner{(right ? width - 1 : 0) * kSteps + kCentre,
                             (bottom ? height - 1 : 0) * kSteps + kCentre};
  const SnappedVertex d = vertex_within(c, 300);
  const std::int64_t n = c.integer(1, 100);
  const SnappedVertex a = moved_by_up_to(c, moved(corner, d.x * n, d.y * n), 1);
  const Triangle t{a, moved(corner, -d.x * n, -d.y * n), vertex_within(c, 20'000)};
  return one_tile(with_area(t), {0, 0, width, height});
}

inline std::vector<InputClass<TileCase>> generated_tiles() {
  return {{"triangles with corners on centres, corners and edges of pixels", 30'000,
           [](Choices& c) { return tile_of(triangle_on_centres(c)); }},
          {"edges at a corner of the tile", 30'000, edge_at_corner},
          {"triangles up to 2^16 pixels, where an edge passes (C-50)", 20'000,
           [](Choices& c) { return tile_of(window_at_edge(c)); }},
          {"large triangles with an edge through a centre", 10'000,
           [](Choices& c) { return tile_of(edge_through_centre(c)); }},
          {"large triangles whose edge passes a centre by less than a step", 10'000,
           [](Choices& c) { return tile_of(edge_beside_centre(c)); }}};
}

}  // namespace inputs
}  // namespace lab_06
