// The inputs of lab 5's cases: the runner passes them to the student's functions, the judge to the
// pipeline's.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <glassbox/base/random.h>

#include "labs/framework/varied_inputs.h"
#include "student.h"

namespace lab_05 {
// A namespace of its own: a function or type of yours in student.cpp may have the name of one of
// these, and does not replace it.
inline namespace inputs {

using glassbox::Random;

// ---- 5.1: faces ----

struct FaceQuestion {
  std::vector<Point<World>> face;
  Point<World> eye;
};
using FaceCase = std::vector<FaceQuestion>;  // one answer for each question

// The faces of a prism between two heights, seen from `eye`. The base of the prism is a polygon of
// the xy plane, counter-clockwise seen from +z.
inline FaceCase prism(const std::vector<std::array<float, 2>>& base, float low, float high,
                      Point<World> eye) {
  std::vector<Point<World>> top, bottom;
  for (const auto& [x, y] : base) {
    top.push_back({x, y, high});
    bottom.insert(bottom.begin(), {x, y, low});
  }
  FaceCase questions{{top, eye}, {bottom, eye}};
  for (std::size_t i = 0; i < base.size(); ++i) {
    const auto [x0, y0] = base[i];
    const auto [x1, y1] = base[(i + 1) % base.size()];
    questions.push_back({{{x0, y0, low}, {x1, y1, low}, {x1, y1, high}, {x0, y0, high}}, eye});
  }
  return questions;
}

// The outline of an L; its corner number `reflex` is the one with an angle of more than 180
// degrees.
inline std::vector<std::array<float, 2>> ell(int reflex) {
  std::vector<std::array<float, 2>> base{{1, 1}, {1, 2}, {0, 2}, {0, 0}, {2, 0}, {2, 1}};
  std::rotate(base.begin(), base.end() - reflex, base.end());
  return base;
}

// The largest possible triangles, with 13 bits in each coordinate, so 26 in a product. In each
// group of three triangles, the eye of the second is exactly in the triangle's plane, at the middle
// of an edge; the eyes of the first and the third are one step (1/16) below and above the middle of
// an edge.
inline FaceCase large_edge_on(std::uint64_t seed) {
  Random random(seed);
  const auto coordinate = [&] { return float(random.integer(-4095, 4095)) / 8; };
  FaceCase questions;
  for (int i = 0; i < 24; ++i) {
    std::array<Point<World>, 3> p;
    for (Point<World>& corner : p) {
      const float x = coordinate(), y = coordinate();
      corner = {x, y, coordinate()};
    }
    Point<World> eye((p[1].x + p[2].x) / 2, (p[1].y + p[2].y) / 2, (p[1].z + p[2].z) / 2);
    eye.z += float(i % 3 - 1) / 16;
    questions.push_back({{p[0], p[1], p[2]}, eye});
  }
  return questions;
}

inline std::vector<FaceCase> solids() {
  const std::vector<std::array<float, 2>> square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  return {prism(square, -1, 1, {3, 0.5f, 0.25f}),
          prism(square, -1, 1, {-2, 4, 3}),
          prism(ell(0), 0, 1, {1.5f, 1.75f, 4}),
          prism(ell(0), 0, 1, {-3, 5, -2}),
          prism(ell(1), 0, 1, {1.5f, 1.75f, 4}),
          prism(square, -1, 1, {1, 0.5f, 4}),  // the eye is in the plane of one side
          large_edge_on(50)};
}

// BEGIN HIDDEN
// Triangles with the shortest possible sides (1/16), in the xy plane and tilted, seen from as near
// as possible.
inline FaceCase small_faces() {
  constexpr float k = 1 / 16.0f;
  FaceCase questions;
  for (const float tilt : {0.0f, k, -k}) {
    for (const float height : {-k, 0.0f, k})
      questions.push_back({{{1, 1, 1}, {1 + k, 1, 1 + tilt}, {1, 1 + k, 1}}, {1, 1, 1 + height}});
  }
  return questions;
}

// Random triangles (in every second question the eye is exactly in the triangle's plane), then
// large and small triangles, and L-shaped prisms whose base begins at any corner.
inline std::vector<FaceCase> faces_edge_on() {
  Random random = glassbox::labs::varied(51);
  const auto coordinate = [&] { return float(random.integer(-128, 128)) / 16; };
  std::vector<FaceCase> all(4);
  for (FaceCase& each : all) {
    for (int i = 0; i < 8; ++i) {
      std::array<Point<World>, 3> p;
      for (Point<World>& corner : p) {
        const float x = coordinate(), y = coordinate();
        corner = {x, y, coordinate()};
      }
      const auto s = float(random.integer(-10, 10)), t = float(random.integer(-10, 10));
      const auto in_plane = [&](float a, float b, float c) {
        return a + s * (b - a) + t * (c - a);
      };
      Point<World> eye(in_plane(p[0].x, p[1].x, p[2].x), in_plane(p[0].y, p[1].y, p[2].y),
                       in_plane(p[0].z, p[1].z, p[2].z));
      if (i % 2 == 1) eye.z += 0.0625f;
      each.push_back({{p[0], p[1], p[2]}, eye});
    }
  }
  for (const std::uint64_t seed : {511u, 512u})
    all.push_back(large_edge_on(glassbox::labs::varied_seed(seed)));
  all.push_back(small_faces());
  for (int reflex = 2; reflex < 6; ++reflex) all.push_back(prism(ell(reflex), 0, 1, {-3, 5, -2}));
  return all;
}
// END HIDDEN

// ---- 5.2: outcodes ----

inline std::vector<Point<Clip>> points() {
  return {{0, 0, 1, 2},     {-3, 0, 1, 2},        {3, 0, 1, 2},  {0, -3, 1, 2}, {0, 3, 1, 2},
          {0, 0, -1, 2},    {0, 0, 3, 2},         {-3, 3, 3, 2}, {2, -2, 0, 2}, {-2, 2, 2, 2},
          {0, 0, 0.5f, -1}, {0.5f, 0.5f, -1, -1}, {0, 0, 0, 0},  {1, -1, -1, 0}};
}

// BEGIN HIDDEN
// Points whose x, y and z take nine different multiples of w/2, so that they are outside, on and
// inside each plane; with w of both signs.
inline std::vector<Point<Clip>> lattice_points() {
  std::vector<Point<Clip>> all;
  for (const float w : {1.5f, -0.75f}) {
    for (int i = 0; i < 9; ++i) {
      const float x = float(i - 4) * 0.5f * w, y = float((2 * i) % 9 - 4) * 0.5f * w;
      all.push_back({x, y, float((4 * i) % 9 - 3) * 0.5f * w, w});
    }
  }
  return all;
}
// END HIDDEN

inline std::vector<std::vector<std::uint32_t>> outcode_lists() {
  return {{0, 0, 0},
          {kLeft, kLeft | kTop, kLeft | kNear},
          {kLeft, kRight, kTop},
          {kLeft, 0, 0},
          {kNear | kLeft, kNear | kRight, kFar | kLeft},
          {kLeft, kLeft, kLeft, kRight},
          {0, 0, 0, 0, kTop},
          {kFar},
          {kFar | kBottom, kBottom, kBottom | kRight, kNear | kBottom}};
}

// ---- 5.3: crossings ----

struct Edge {
  Plane plane;
  Point<Clip> p, q;
};

inline double distance_from(const Plane& plane, const Point<Clip>& p) {
  return plane.a * p.x + plane.b * p.y + plane.c * p.z + plane.d * p.w;
}

// An edge whose coordinates use all digits of a float, and whose ends are on different sides of the
// plane.
inline Edge random_edge(Random& random, const Plane& plane) {
  const auto point = [&] {
    const auto coordinate = [&] { return float(random.between(-10, 10)); };
    const float x = coordinate(), y = coordinate(), z = coordinate();
    return Point<Clip>(x, y, z, float(random.between(-1, 10)));
  };
  for (;;) {
    const Edge edge{plane, point(), point()};
    if (distance_from(plane, edge.p) * distance_from(plane, edge.q) < -0.01) return edge;
  }
}

inline std::vector<Edge> edges(std::uint64_t seed, int each) {
  Random random(seed);
  std::vector<Edge> all;
  for (const Plane& plane : kFrustum) {
    for (int i = 0; i < each; ++i) all.push_back(random_edge(random, plane));
  }
  return all;
}
inline std::vector<Edge> some_edges() {
  return edges(53, 1);
}

// Several edges in one case: a single one may by luck give the same bits from both ends.
using EdgesCase = std::vector<Edge>;
inline std::vector<EdgesCase> edges_both_ways() {
  std::vector<EdgesCase> all;
  for (std::uint64_t seed = 530; seed < 534; ++seed) all.push_back(edges(seed, 2));
  return all;
}

// BEGIN HIDDEN
inline std::vector<Edge> other_edges() {
  std::vector<Edge> all = edges(glassbox::labs::varied_seed(54), 1);
  // Each row: x and w of p, then x and w of q. The x of their crossing is half-way between two
  // floats, and is the nearest double. On paper the w of the crossing is the same number, but
  // computed in double it has lost the digits that show that it is half-way.
  constexpr std::array<std::array<float, 4>, 3> kApart{
      {{14803879, 1599421440, 10933927, -1799110400},
       {7425691, 1953577216, 11442587, -1267097088},
       {16666339, 1534321408, 1380323, -2592284160}}};
  const auto& [a, b, c] = kApart;
  all.push_back({kFrustum[3], {a[0], 1, 2, a[1]}, {a[2], 2, 1, a[3]}});
  all.push_back({kFrustum[2], {-b[0], 1, 2, b[1]}, {-b[2], 2, 1, b[3]}});
  all.push_back({kFrustum[5], {1, b[0], 2, b[1]}, {2, b[2], 1, b[3]}});
  all.push_back({kFrustum[4], {1, -a[0], 2, a[1]}, {2, -a[2], 1, a[3]}});
  all.push_back({kFrustum[1], {1, 2, c[0], c[1]}, {2, 1, c[2], c[3]}});
  return all;
}

// Edges whose crossing with the near plane is half-way between two floats, and where p + t (q - p),
// computed in double and rounded once, gives different results from the two ends. About one in
// three thousand edges with such a crossing gives different results.
inline std::vector<EdgesCase> ties() {
  struct Tie {
    float p_z, q_z, p_x, q_x;
  };
  constexpr std::array<Tie, 8> kTies{{
      {3, -7, 9410923.0f, 32608568.0f},
      {2, -9, 15238326.0f, -3512997.25f},
      {3, -7, 8654671.0f, 30292476.0f},
      {3, -7, 16244169.0f, -4915116.0f},
      {2, -9, 15187599.0f, -4034749.75f},
      {5, -9, 16466660.0f, -3871217.0f},
      {2, -9, 16535227.0f, -3859017.75f},
      {5, -9, 16176306.0f, -5061407.0f},
  }};
  std::vector<EdgesCase> all;
  for (std::size_t i = 0; i < kTies.size(); i += 2) {
    EdgesCase edges;
    for (const auto& [p_z, q_z, p_x, q_x] : {kTies[i], kTies[i + 1]})
      edges.push_back({kFrustum[0], {p_x, 1, p_z, 8}, {q_x, 2, q_z, 16}});
    all.push_back(edges);
  }
  return all;
}
// END HIDDEN

// ---- 5.4: polygons and one plane ----

struct PlaneCase {
  const char* what;
  Plane plane;
  Polygon polygon;
};

inline std::vector<PlaneCase> polygons() {
  const Plane near = kFrustum[0], right = kFrustum[3], top = kFrustum[5];
  return {
      {"all inside", near, {{0, 0, 1, 2}, {1, 0, 2, 3}, {0, 1, 1, 2}}},
      {"all outside", near, {{0, 0, -1, 1}, {1, 0, -2, 1}, {0, 1, -1, 1}}},
      {"one inside", near, {{0, 0, 3, 4}, {1, 0, -1, 1}, {0, 1, -3, 1}}},
      {"two inside", right, {{0, 0, 1, 2}, {5, 0, 1, 2}, {0, 1, 1, 2}}},
      {"one corner inside, one on the plane, one outside",
       top,
       {{0, 0, 1, 2}, {1, 2, 1, 2}, {0, 6, 2, 3}}},
      {"two corners inside, one on the plane", right, {{2, 0, 1, 2}, {0, 1, 1, 2}, {0, -1, 1, 2}}},
      {"one corner on the plane, the others outside",
       near,
       {{0, 0, 0, 1}, {1, 0, -1, 1}, {1, 1, -2, 1}}},
      {"a quad that loses its last corner",
       right,
       {{0, -1, 1, 2}, {1, -1, 1, 2}, {1, 1, 1, 2}, {3, 1, 1, 2}}}};
}

// BEGIN HIDDEN
inline std::vector<PlaneCase> more_polygons() {
  const Plane far = kFrustum[1], left = kFrustum[2], bottom = kFrustum[4];
  return {
      {"an edge in the plane, and the other corners inside",
       far,
       {{0, 0, 2, 2}, {1, 0, 3, 3}, {0, 1, 1, 2}}},
      {"an edge in the plane, and the other corners outside",
       far,
       {{0, 0, 2, 2}, {1, 0, 3, 3}, {0, 1, 4, 2}}},
      {"a triangle in the plane", left, {{-2, 0, 1, 2}, {-3, 1, 1, 3}, {-1, 1, 1, 1}}},
      {"two corners of a square on the plane",
       bottom,
       {{0, -3, 1, 2}, {1, -2, 1, 2}, {0, -1, 1, 2}, {-1, -2, 1, 2}}},
      {"a hexagon, three corners outside",
       left,
       {{2, 0, 1, 2}, {1, 2, 1, 2}, {-3, 2, 1, 2}, {-4, 0, 1, 2}, {-3, -2, 1, 2}, {1, -2, 1, 2}}},
      {"w of both signs", left, {{1, 0, 1, -2}, {0, 1, 1, 3}, {0, -1, 1, 3}}},
      {"one corner inside and one outside by a millionth",
       kFrustum[0],
       {{1, 0, 1e-6f, 1}, {2, 1, 1, 3}, {-1, 1, 1, 2}, {-1, 0, -1e-6f, 1}}},
      {"an edge that crosses the far plane almost parallel to it",
       far,
       {{1.5f, -7.3f, 23.00001f, 23}, {-9.1f, 3.7f, 27.29999f, 27.3f}, {2, 1, 3.3f, 21}}}};
}
// END HIDDEN

// ---- 5.5: triangles and the frustum ----

struct FrustumCase {
  const char* what;
  std::array<Point<Clip>, 3> triangle;
};

inline std::vector<FrustumCase> triangles() {
  return {
      {"inside", {{{-1, -1, 1, 2}, {1, -1, 1, 2}, {0, 1, 1, 2}}}},
      {"a triangle that contains the whole picture",
       {{{-9, -4, 1, 2}, {9, -4, 1, 2}, {0, 14, 1, 2}}}},
      {"a triangle that crosses the plane of the eye",
       {{{0.25f, 0.25f, 0.5f, 1}, {1, -2, -1.5f, -1}, {-2, -1, -1.5f, -1}}}},
      {"behind the eye", {{{0, 0, -2, -1}, {1, 0, -3, -2}, {0, 1, -2, -1}}}},
      {"a corner on each of three planes", {{{-2, 0, 1, 2}, {0, -2, 1, 2}, {2, 1, 1, 2}}}},
      {"a triangle that passes a corner of the picture without touching it",
       {{{1, 3.5f, 1, 2}, {3.5f, 1, 1, 2}, {4, 4, 1, 2}}}},
      {"a triangle that reaches from in front of the near plane to behind the far plane",
       {{{0, -1, -5, 2}, {1, 0, 5, 3}, {-1, 0.5f, 4, 3.5f}}}},
      {"a corner that is outside by less than a rounding error: its two crossings are one vertex",
       {{{0.5f, 0.5f, -1e-10f, 2}, {1, 0, 1, 2}, {0, 1, 1, 2}}}}};
}

// Two triangles that form a square, which reaches across the near plane and out of the picture:
// `shared` are the ends of their common edge, `apexes` their third corners, all in clip space.
struct Pair {
  std::array<Point<Clip>, 2> shared;
  std::array<Point<Clip>, 2> apexes;

  std::array<Point<Clip>, 3> first() const { return {shared[0], shared[1], apexes[0]}; }
  std::array<Point<Clip>, 3> second() const { return {shared[1], shared[0], apexes[1]}; }
};
using PairsCase = std::vector<Pair>;

inline std::vector<PairsCase> pairs_of_triangles() {
  Random random(55);
  const auto between = [&](double low, double high) { return float(random.between(low, high)); };
  std::vector<PairsCase> all(4);
  for (PairsCase& each : all) {
    for (int i = 0; i < 8; ++i) {
      // The common edge goes from a point in the picture to one behind the near plane; the third
      // corners of the two triangles are on different sides of it.
      const float ax = between(-1, 1), ay = between(-1, 1), bx = between(-2, 2),
                  by = between(-2, 2);
      const Point<Clip> a{ax, ay, between(1, 2), 3}, b{bx, by, between(-2, -1), between(0.5, 1)};
      const float cx = between(1, 2), dx = between(-2, -1);
      each.push_back({{a, b}, {Point<Clip>(cx, 0, 1, 3), Point<Clip>(dx, 0, 1, 3)}});
    }
  }
  return all;
}

// BEGIN HIDDEN
inline std::vector<FrustumCase> more_triangles() {
  std::vector<FrustumCase> all{
      {"a triangle that all six planes cut",
       {{{-9, -3, -3, 2}, {4, -3.5f, 1, 2}, {1, 9, 4.5f, 2}}}},
      {"a triangle of which nine vertices are left",
       {{{5.5f, 0, 4.5f, 4}, {-6, -5, -3.5f, 0.5f}, {0, 4.5f, 3, 4}}}},
      {"two corners behind the eye", {{{0, 0.5f, 2, 3}, {3, -8, -4, -2}, {-4, -9, -5, -3}}}},
      {"a corner where three planes meet", {{{2, 2, 0, 2}, {-1, 0, 1, 2}, {0, -1, 1, 2}}}},
      {"a corner far in front of the near plane, in the middle of the picture",
       {{{0.25f, 0, -4, 1.5f}, {1, -1, 1, 2}, {-1, 1, 1.5f, 2}}}},
      {"the second corner is outside by less than a rounding error",
       {{{0, 1, 1, 2}, {0.5f, 0.5f, -1e-10f, 2}, {1, 0, 1, 2}}}},
      {"two corners are outside by less than a rounding error",
       {{{2.5e-10f, 0, -1e-10f, 2}, {0, 0, -1e-10f, 2}, {0.5f, 0.75f, 1, 2}}}},
      {"one corner is inside by less than a rounding error, and the others are outside",
       {{{0.5f, 0.5f, 1e-10f, 2}, {1, 0, -1, 2}, {0, 1, -1, 2}}}}};
  Random random = glassbox::labs::varied(56);
  while (all.size() < 13) {
    std::array<Point<Clip>, 3> t;
    for (Point<Clip>& p : t) {
      const auto x = float(random.between(-6, 6)), y = float(random.between(-6, 6));
      const auto z = float(random.between(-1, 4));
      p = {x, y, z, float(random.between(1, 4))};
    }
    all.push_back({"random", t});
  }
  return all;
}

// A surface that fills a picture, cut into `count` triangles around a point in it. Its outer
// corners are far outside the picture, and some of them behind the eye.
inline std::vector<std::array<Point<Clip>, 3>> fan_of_triangles(int count) {
  // A point of the plane z = -(3 + x/2 + y/4) of eye space, in clip space: the field of view has 90
  // degrees, near is 1/2 and far 64.
  const auto on_plane = [](double x, double y) {
    const double w = 3 + x / 2 + y / 4;
    return Point<Clip>(float(x), float(y), float(64.0 / 63.5 * (w - 0.5)), float(w));
  };
  std::vector<std::array<Point<Clip>, 3>> fan;
  const auto corner = [&](int i) {
    const double angle = 2 * 3.14159265358979323846 * (i % count + 0.3) / count;
    return on_plane(4 + 60 * std::cos(angle), 2 + 60 * std::sin(angle));
  };
  for (int i = 0; i < count; ++i) fan.push_back({on_plane(0.3, -0.2), corner(i), corner(i + 1)});
  return fan;
}
inline std::vector<int> fan_counts() {
  return {5, 7, 12, 40};
}
// END HIDDEN

}  // namespace inputs
}  // namespace lab_05
