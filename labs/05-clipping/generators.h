// The generated inputs of lab 5: up to 100,000 for each function, of all kinds that student.h names
// and of the borders between them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "cases.h"
#include "labs/framework/choices.h"

namespace lab_05 {
// A namespace of its own: a function or type of yours in student.cpp may have the name of one of
// these, and does not replace it.
inline namespace inputs {

using glassbox::labs::Choices;
using glassbox::labs::InputClass;

using ClipPoint = Point<Clip>;

// ---- faces (task 5.1) ----

// A position in world space, counted in steps of 1/16.
struct Steps {
  std::int64_t x = 0, y = 0, z = 0;
};
inline constexpr std::int64_t kLargestStep = 512 * 16 - 1;

inline bool in_range(const Steps& p) {
  const auto inside = [](std::int64_t at) { return at >= -kLargestStep && at <= kLargestStep; };
  return inside(p.x) && inside(p.y) && inside(p.z);
}
// origin + a u + b v
inline Steps in_plane(const Steps& origin, const Steps& u, std::int64_t a, const Steps& v,
                      std::int64_t b) {
  return {origin.x + a * u.x + b * v.x, origin.y + a * u.y + b * v.y, origin.z + a * u.z + b * v.z};
}
inline Point<World> position(const Steps& p) {
  return {float(p.x) / 16, float(p.y) / 16, float(p.z) / 16};
}
inline Steps steps_within(Choices& c, std::int64_t reach) {
  const std::int64_t x = c.integer(-reach, reach), y = c.integer(-reach, reach);
  return {x, y, c.integer(-reach, reach)};
}

// A corner of a face, as a sum of two vectors that span its plane.
struct FlatCorner {
  std::int64_t a, b;
};
// A polygon whose lower side is y = 0 or a zigzag below it and whose upper side is a zigzag above:
// most corners of a zigzag are reflex. Any corner may be the first, and either side may be outside.
inline std::vector<FlatCorner> zigzag(Choices& c) {
  std::vector<FlatCorner> corners;
  const auto across = std::int64_t(1 + c.below(5));
  for (std::int64_t i = 0; i <= across; ++i) corners.push_back({i, -std::int64_t(c.below(4))});
  for (std::int64_t i = across; i >= 0; --i) corners.push_back({i, 1 + std::int64_t(c.below(4))});
  if (c.flag()) std::reverse(corners.begin(), corners.end());
  std::rotate(corners.begin(), corners.begin() + std::ptrdiff_t(c.below(corners.size())),
              corners.end());
  return corners;
}
inline std::vector<FlatCorner> triangle_corners(Choices& c) {
  if (c.flag()) return {{0, 0}, {0, 1}, {1, 0}};
  return {{0, 0}, {1, 0}, {0, 1}};
}

// A face in the plane of two vectors, of up to 2 `size` each, and an eye in this plane, a step
// beside it, or anywhere. The eye may be in the middle of an edge.
inline FaceCase any_face(Choices& c, std::vector<FlatCorner> (*corners)(Choices&),
                         std::int64_t reach, std::int64_t size) {
  const Steps origin = steps_within(c, reach);
  Steps u = steps_within(c, size), v = steps_within(c, size);
  const bool flat = u.y * v.z == u.z * v.y && u.z * v.x == u.x * v.z && u.x * v.y == u.y * v.x;
  if (flat) u = {1, 0, 0}, v = {0, 1, 0};
  const std::int64_t scale = 1 + std::int64_t(c.below(2));
  FaceQuestion question;
  for (const auto& [a, b] : corners(c))
    question.face.push_back(position(in_plane(origin, u, a * scale, v, b * scale)));
  const std::int64_t s = c.integer(-3, 6), t = c.integer(-3, 6);
  const std::uint64_t where = c.below(8);
  const std::int64_t step = c.flag() ? -1 : 1;
  Steps from = origin;  // or a step beside it, and with it the eye
  if (where == 1) from.x += step;
  if (where == 2) from.y += step;
  if (where == 3) from.z += step;
  Steps eye = in_plane(from, u, s, v, t);
  if (!in_range(eye)) eye = in_plane(from, u, 1, v, scale - 1);
  if (where == 4) eye = steps_within(c, kLargestStep);
  question.eye = position(eye);
  return {question};
}

inline std::vector<InputClass<FaceCase>> generated_faces() {
  return {{"triangles of every size, seen edge-on and from a step beside (C-27, C-28)", 40'000,
           [](Choices& c) {
             const std::int64_t size = std::int64_t(1) << c.below(11);
             return any_face(c, triangle_corners, 4096, size);
           }},
          {"large triangles, seen edge-on and from a step beside", 20'000,
           [](Choices& c) { return any_face(c, triangle_corners, 4000, 2047); }},
          {"faces with reflex corners, of which any may be the first", 40'000, [](Choices& c) {
             const std::int64_t size = std::int64_t(1) << c.below(8);
             return any_face(c, zigzag, 4000, size);
           }}};
}

// ---- outcodes (task 5.2) ----

inline constexpr float kSmallestFloat = 0x1p-149f;
inline constexpr float kLargestFloat = std::numeric_limits<float>::max();

// A float of every size, not 0.
inline float any_float(Choices& c, int lowest = -149, int highest = 127) {
  const double value = c.real(lowest, highest);  // rounding may make it infinite
  return float(std::clamp(value, -double(kLargestFloat), double(kLargestFloat)));
}

// A coordinate at w or -w, one step beside them, at 0, half-way, or anywhere.
inline float coordinate_beside(Choices& c, float w) {
  switch (c.below(6)) {
    case 0:
      return c.near(w);
    case 1:
      return c.near(-w);
    case 2:
      return c.near(0.0f);
    case 3:
      return c.one_of({w / 2, -w / 2, 2 * w, -2 * w, 0.0f, -0.0f});
    case 4:
      return any_float(c);
    default:
      return c.one_of({HUGE_VALF, -HUGE_VALF, kLargestFloat, -kLargestFloat});
  }
}
inline ClipPoint point_for(Choices& c, float w) {
  const float x = coordinate_beside(c, w), y = coordinate_beside(c, w);
  return {x, y, coordinate_beside(c, w), w};
}

inline std::vector<InputClass<ClipPoint>> generated_clip_points() {
  return {
      {"points on the planes and a step beside them, with w of every size and sign (C-34)", 60'000,
       [](Choices& c) {
         const float w = any_float(c);
         return point_for(c, w);
       }},
      {"points with w = 0, at the ends of a float's range, and infinite (C-33, C-40)", 20'000,
       [](Choices& c) {
         const float w = c.one_of({0.0f, -0.0f, kSmallestFloat, -kSmallestFloat, kLargestFloat,
                                   -kLargestFloat, HUGE_VALF, -HUGE_VALF});
         return point_for(c, w);
       }},
      {"points with a coordinate that is NaN", 20'000, [](Choices& c) {
         const float w = any_float(c);
         ClipPoint p = point_for(c, w);
         const float nan = std::numeric_limits<float>::quiet_NaN();
         const std::uint64_t which = 1 + c.below(15);
         if ((which & 1) != 0) p.z = nan;
         if ((which & 2) != 0) p.x = nan;
         if ((which & 4) != 0) p.y = nan;
         if ((which & 8) != 0) p.w = nan;
         return p;
       }}};
}

using Codes = std::vector<std::uint32_t>;

inline std::vector<InputClass<Codes>> generated_codes() {
  return {{"codes that have a bit in common", 15'000,
           [](Choices& c) {
             const std::uint32_t common = 1u << c.below(6);
             Codes codes(1 + c.below(12));
             for (std::uint32_t& code : codes) code = common | std::uint32_t(c.below(64));
             if (c.flag()) codes[c.below(codes.size())] &= ~common;
             return codes;
           }},
          {"codes with few bits, of 1 to 12 vertices", 15'000, [](Choices& c) {
             Codes codes(1 + c.below(12));
             for (std::uint32_t& code : codes) {
               const std::uint64_t kind = c.below(4);
               if (kind == 1) code = 1u << c.below(6);
               if (kind == 2) code = std::uint32_t(c.below(64));
             }
             return codes;
           }}};
}

// ---- crossings (task 5.3) ----

// A point at the given distance from a plane of kFrustum: the plane's own coordinate follows from
// the distance and w. It is rounded, so the distance is the given one only nearly.
inline ClipPoint point_at(const Plane& plane, double distance, float x, float y, float z, float w) {
  ClipPoint p(x, y, z, w);
  const double rest = distance - plane.d * double(w);
  const auto own = [rest](double factor) {
    return float(std::clamp(rest * factor, -double(kLargestFloat), double(kLargestFloat)));
  };
  if (plane.a != 0) p.x = own(plane.a);
  if (plane.b != 0) p.y = own(plane.b);
  if (plane.c != 0) p.z = own(plane.c);
  return p;
}

// The plane's own coordinate of a point.
inline float& own_coordinate(const Plane& plane, ClipPoint& p) {
  return plane.a != 0 ? p.x : plane.b != 0 ? p.y : p.z;
}
// Moves a point that is not strictly on the wanted side (1: inside, -1: outside) there: to the next
// float beside the plane. Beside the largest float there is none; then w becomes smaller in size,
// which has the same effect on the distance.
inline void put_strictly_on_side(const Plane& plane, ClipPoint& p, int side) {
  const double factor = plane.a + plane.b + plane.c;  // only one of the three is not 0
  float& own = own_coordinate(plane, p);
  const auto on_plane = float(-plane.d * factor * double(p.w));
  if ((double(own) - on_plane) * factor * side > 0) return;
  own = std::nextafter(on_plane, float(factor * side * HUGE_VAL));
  if (std::isfinite(own)) return;
  own = on_plane;
  p.w = std::nextafter(p.w, 0.0f);
}

inline Plane any_plane(Choices& c) {
  return kFrustum[c.below(6)];
}

inline ClipPoint any_clip_point(Choices& c, int lowest, int highest) {
  const float x = any_float(c, lowest, highest), y = any_float(c, lowest, highest);
  const float z = any_float(c, lowest, highest);
  return {x, y, z, any_float(c, lowest, highest)};
}

// An edge from a point inside to one outside, or the other way round.
inline Edge edge_between(Choices& c, const Plane& plane, ClipPoint p, ClipPoint q) {
  put_strictly_on_side(plane, p, 1);
  put_strictly_on_side(plane, q, -1);
  if (c.flag()) std::swap(p, q);
  return {plane, p, q};
}
inline Edge any_edge(Choices& c, int size, int spread) {
  const Plane plane = any_plane(c);
  const ClipPoint p = any_clip_point(c, size - spread, size + spread);
  const ClipPoint q = any_clip_point(c, size - spread, size + spread);
  return edge_between(c, plane, p, q);
}
// The ends are any distances from the plane, down to the next float.
inline Edge edge_close_to_plane(Choices& c) {
  const Plane plane = any_plane(c);
  const ClipPoint p = any_clip_point(c, -3, 3), q = any_clip_point(c, -3, 3);
  const double at_p = c.positive(-60, 2), at_q = -c.positive(-60, 2);
  return edge_between(c, plane, point_at(plane, at_p, p.x, p.y, p.z, p.w),
                      point_at(plane, at_q, q.x, q.y, q.z, q.w));
}
// The x and z of the ends of an edge whose crossing with the near plane is half-way between two
// floats (C-38). x goes from middle - k step to middle + m step, where z goes from k to -m.
struct TiedEnds {
  float p_x, p_z, q_x, q_z;
};
// In halves, the middle is an odd number between 2^24 and 3 * 2^23. The ends have to be floats.
// That of p is whole and below 2^24 in size. That of q is below 2^26 and a multiple of 4:
// middle + m step is a multiple of 8, because m^2 - 1 is. With ends so far apart, p + t (q - p) in
// double, rounded once, gives one in 30 of these edges different crossings from its two ends.
inline TiedEnds tied_ends(Choices& c) {
  const auto k = 1 + 2 * std::int64_t(c.below(8)), m = 1 + 2 * std::int64_t(c.below(8));
  const std::int64_t middle = (std::int64_t(1) << 24) + 2 * std::int64_t(c.below(1u << 22)) + 1;
  const std::int64_t most = std::min((std::int64_t(1) << 25) / k, (std::int64_t(1) << 26) / m);
  const std::int64_t step = 8 - middle * m % 8 + 8 * std::int64_t(c.below(std::uint64_t(most / 8)));
  return {float(double(middle - k * step) / 2), float(k), float(double(middle + m * step) / 2),
          -float(m)};
}
inline Edge edge_with_tie(Choices& c) {
  const auto [p_x, p_z, q_x, q_z] = tied_ends(c);
  const float y = any_float(c, -3, 3);
  return edge_between(c, kFrustum[0], {p_x, y, p_z, 8}, {q_x, 2, q_z, 16});
}

inline std::vector<InputClass<Edge>> generated_edges() {
  return {{"edges of moderate size", 20'000, [](Choices& c) { return any_edge(c, 0, 3); }},
          {"edges of every size, from the smallest floats to the largest (C-40)", 20'000,
           [](Choices& c) {
             const int size = int(c.integer(-140, 118)), spread = c.one_of({0, 3, 9});
             return any_edge(c, size, spread);
           }},
          {"edges whose ends are of very different sizes", 10'000,
           [](Choices& c) { return any_edge(c, 0, 120); }},
          {"edges that end next to the plane, or are nearly parallel to it", 20'000,
           edge_close_to_plane},
          {"edges whose crossing is half-way between two floats (C-38)", 30'000, edge_with_tie}};
}

// ---- polygons and one plane (task 5.4) ----

// Corners of a convex polygon, as sums of two vectors: on a parabola, or a parallelogram.
inline std::vector<FlatCorner> convex(Choices& c) {
  const std::uint64_t kind = c.below(3);
  if (kind == 0) return {{0, 0}, {1, 0}, {0, 1}};
  if (kind == 1) return {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  std::vector<FlatCorner> corners;
  std::int64_t t = -std::int64_t(c.below(5));
  for (std::uint64_t i = 3 + c.below(5); i > 0; --i) {
    corners.push_back({t, t * t});
    t += 1 + std::int64_t(c.below(2));
  }
  return corners;
}
inline ClipPoint whole_point(Choices& c, std::int64_t reach) {
  const auto x = float(c.integer(-reach, reach)), y = float(c.integer(-reach, reach));
  const auto z = float(c.integer(-reach, reach));
  return {x, y, z, float(c.integer(-reach, reach))};
}
// Whole coordinates, so that many vertices and edges are exactly on the plane.
inline PlaneCase whole_polygon(Choices& c) {
  PlaneCase made{"a convex polygon", any_plane(c), {}};
  const std::int64_t reach = c.integer(1, 6);
  const ClipPoint o = whole_point(c, reach), u = whole_point(c, reach), v = whole_point(c, reach);
  const float scale = std::ldexp(1.0f, int(c.integer(-20, 20)));
  for (const auto& [i, j] : convex(c)) {
    const auto a = float(i), b = float(j);
    made.polygon.push_back({(o.x + a * u.x + b * v.x) * scale, (o.y + a * u.y + b * v.y) * scale,
                            (o.z + a * u.z + b * v.z) * scale, (o.w + a * u.w + b * v.w) * scale});
  }
  return made;
}
// A triangle each of whose corners is on the plane, next to it, near it, or anywhere.
inline PlaneCase triangle_at_plane(Choices& c) {
  PlaneCase made{"a triangle", any_plane(c), {}};
  for (int i = 0; i < 3; ++i) {
    ClipPoint p = any_clip_point(c, -3, 3);
    const std::uint64_t kind = c.below(4);
    const double distance = c.real(-60, 2);
    if (kind > 0) p = point_at(made.plane, kind == 3 ? distance : 0, p.x, p.y, p.z, p.w);
    if (kind == 2) {
      float& own = own_coordinate(made.plane, p);
      own = c.near(own);
    }
    made.polygon.push_back(p);
  }
  return made;
}
inline PlaneCase triangle_of_any_size(Choices& c) {
  PlaneCase made{"a triangle", any_plane(c), {}};
  const int size = int(c.integer(-140, 118)), spread = c.one_of({0, 3, 9});
  for (int i = 0; i < 3; ++i)
    made.polygon.push_back(any_clip_point(c, size - spread, size + spread));
  return made;
}

inline std::vector<InputClass<PlaneCase>> generated_polygons() {
  return {{"convex polygons with vertices and edges on the plane (C-35)", 30'000, whole_polygon},
          {"triangles whose corners are on the plane or next to it", 30'000, triangle_at_plane},
          {"triangles of every size", 20'000, triangle_of_any_size}};
}

// ---- triangles and the frustum (task 5.5) ----

using Corners = std::array<ClipPoint, 3>;

inline FrustumCase one_triangle(const Corners& corners) {
  return {"a triangle", corners};
}

inline float between(Choices& c, int low, int high) {
  return float(c.multiple(low, high, 1 << 16));
}
// A corner in front of the eye or behind it, in the picture or beyond its edges.
inline ClipPoint corner(Choices& c, int behind) {
  const float x = between(c, -9, 9), y = between(c, -9, 9), z = between(c, -5, 6);
  return {x, y, z, between(c, behind, 6)};
}
inline FrustumCase triangle_in_front(Choices& c) {
  const ClipPoint p = corner(c, 1), q = corner(c, 1);
  return one_triangle({p, q, corner(c, 1)});
}
inline FrustumCase triangle_beside_eye(Choices& c) {
  const ClipPoint p = corner(c, -6), q = corner(c, -6);
  return one_triangle({p, q, corner(c, -6)});
}
// Whole coordinates: corners and edges on the planes.
inline FrustumCase triangle_on_planes(Choices& c) {
  const ClipPoint p = whole_point(c, 3), q = whole_point(c, 3);
  return one_triangle({p, q, whole_point(c, 3)});
}
// A triangle that surrounds the picture: it is cut by many planes (C-36).
inline FrustumCase large_triangle(Choices& c) {
  Corners corners;
  for (ClipPoint& p : corners) {
    const float w = between(c, 1, 4), z = between(c, -4, 6);
    const float x = between(c, -8, 8);
    p = {x, between(c, -8, 8), z, w};
  }
  return one_triangle(corners);
}
inline ClipPoint scaled(const ClipPoint& p, int size) {
  return {std::ldexp(p.x, size), std::ldexp(p.y, size), std::ldexp(p.z, size),
          std::ldexp(p.w, size)};
}
// The same at every scale; the planes have no scale of their own.
inline FrustumCase scaled_triangle(Choices& c) {
  FrustumCase made = triangle_in_front(c);
  const int size = int(c.integer(-90, 120));
  for (ClipPoint& p : made.triangle) p = scaled(p, size);
  return made;
}

inline std::vector<InputClass<FrustumCase>> generated_triangles() {
  return {{"triangles in front of the eye", 2'000, triangle_in_front},
          {"triangles beside the eye and through it (C-32, C-34)", 2'000, triangle_beside_eye},
          {"triangles with corners and edges on the planes (C-35)", 2'000, triangle_on_planes},
          {"large triangles, cut by many planes (C-36)", 2'000, large_triangle},
          {"triangles of every scale (C-40)", 1'000, scaled_triangle}};
}

// A point in the picture, or on its edges.
inline ClipPoint point_in_picture(Choices& c) {
  constexpr std::int64_t kWhole = 1 << 16;
  const auto coordinate = [](std::int64_t steps) { return float(double(steps) / kWhole); };
  const std::int64_t w = c.integer(kWhole, 6 * kWhole), x = c.integer(-w, w);
  const std::int64_t y = c.integer(-w, w), z = c.integer(0, w);
  return {coordinate(x), coordinate(y), coordinate(z), coordinate(w)};
}
// Two triangles that share an edge, in front of the eye or through it. One end is in the picture,
// so that a part of the edge is left.
inline PairsCase pair_of_triangles(Choices& c) {
  const ClipPoint a = point_in_picture(c), b = corner(c, -2), p = corner(c, 1);
  return {Pair{{a, b}, {p, corner(c, 1)}}};
}
// The crossing of the shared edge with the near plane is half-way between two floats, and in the
// picture: |x| < w there.
inline PairsCase pair_with_tie(Choices& c) {
  const auto [p_x, p_z, q_x, q_z] = tied_ends(c);
  const float p_y = between(c, -9, 9);
  const ClipPoint p{p_x, p_y, p_z, 0x1p26f}, q{q_x, between(c, -9, 9), q_z, 0x1p26f};
  const ClipPoint apex = scaled(corner(c, 1), 24);
  const Pair pair{{p, q}, {apex, scaled(corner(c, 1), 24)}};
  if (c.flag()) return {Pair{{q, p}, pair.apexes}};
  return {pair};
}

inline std::vector<InputClass<PairsCase>> generated_pairs() {
  return {{"two triangles with a common edge that begins in the picture (C-38)", 3'000,
           pair_of_triangles},
          {"a common edge that is cut half-way between two floats (C-38)", 2'000, pair_with_tie}};
}

}  // namespace inputs
}  // namespace lab_05
