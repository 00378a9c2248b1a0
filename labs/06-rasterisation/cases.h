// The inputs of lab 6's test cases: for the runner, which calls the student's functions, and for
// the checks, which compute the expected answers.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <glassbox/base/random.h>

#include "labs/framework/varied_inputs.h"
#include "student.h"

namespace lab_06 {
// A namespace of its own: a function or type of yours in student.cpp may have the name of one of
// these, and does not replace it.
inline namespace inputs {

using glassbox::Random;

// A snapped vertex at a position in pixels; exact for multiples of 1/256 pixel.
inline SnappedVertex at(double x, double y) {
  return {std::int32_t(x * kSteps), std::int32_t(y * kSteps)};
}

// ---- positions (task 6.1) ----

struct SnapCase {
  const char* what;
  std::vector<float> pixels;
};

inline std::vector<SnapCase> positions() {
  return {{"multiples of 1/256", {0.0f, 1.0f, 10.5f, -3.25f, 0.00390625f, 1919.99609375f}},
          {"between two steps", {0.001f, 0.1f, 100.3f, -0.3f, -17.77f, 639.999f}},
          {"halfway between two steps: k/512 (C-52)",
           {1 / 512.0f, 3 / 512.0f, 5 / 512.0f, -1 / 512.0f, -3 / 512.0f, 100 + 7 / 512.0f}}};
}

// BEGIN HIDDEN
inline std::vector<SnapCase> more_positions() {
  SnapCase near_ties{"the floats next to a half step", {}};
  for (const int k : {1, 3, 5, -1, -3, -5, 513, -1025}) {
    const float tie = float(k) / 512;
    near_ties.pixels.push_back(std::nextafter(tie, -1e9f));
    near_ties.pixels.push_back(std::nextafter(tie, 1e9f));
  }
  Random random = glassbox::labs::varied(61);
  SnapCase far{"large positions", {}};
  for (int i = 0; i < 50; ++i) far.pixels.push_back(float(random.between(-65535, 65535)));
  return {near_ties, far, {"positions near 0", {1e-30f, -1e-30f, 1e-3f, -1e-3f, 0.99999994f}}};
}
// END HIDDEN

// ---- edges (tasks 6.2 and 6.3) ----

struct EdgeCase {
  const char* what;
  std::vector<Triangle> samples;  // each: an edge from a to b, and a point p
};

inline Triangle random_sample(Random& random, std::int64_t reach) {
  Triangle t;
  for (SnappedVertex& v : t)
    v = {std::int32_t(random.integer(-reach, reach)), std::int32_t(random.integer(-reach, reach))};
  return t;
}

inline std::vector<EdgeCase> edges() {
  Random random(62);
  EdgeCase picture{"points around edges of a small picture", {}};
  for (int i = 0; i < 12; ++i) picture.samples.push_back(random_sample(random, 64 * kSteps));
  return {{"the three edges of a clockwise and of a counter-clockwise triangle, at a point inside",
           {{at(1, 1), at(9, 1), at(3, 3)},
            {at(9, 1), at(1, 9), at(3, 3)},
            {at(1, 9), at(1, 1), at(3, 3)},
            {at(1, 1), at(1, 9), at(3, 3)},
            {at(1, 9), at(9, 1), at(3, 3)},
            {at(9, 1), at(1, 1), at(3, 3)}}},
          {"edges across 65,536 pixels, whose products need 50 bits (C-50)",
           {{SnappedVertex{-0x7fffff, -0x7ffff0}, {0x7fffff, 0x7ffff1}, {0x7ffff0, -0x7fffff}},
            {SnappedVertex{0x7fffff, -0x7ffff1}, {-0x7ffff3, 0x7ffff5}, {3, 5}}}},
          picture};
}

// BEGIN HIDDEN
inline std::vector<EdgeCase> far_edges() {
  Random random = glassbox::labs::varied(63);
  EdgeCase large{"edges 8,192 and 32,768 pixels long (C-50)", {}},
      close{"points on edges of 32,768 pixels and next to them", {}};
  for (int i = 0; i < 20; ++i)
    large.samples.push_back(random_sample(random, (i % 2 ? 8192 : 32768) * kSteps));
  for (int i = 0; i < 20; ++i) {
    const SnappedVertex a{-0x800000 + i, -0x7ffff0}, b{0x7fffff, 0x7ffff1 - 3 * i};
    const int off = i % 3 - 1;
    close.samples.push_back({a, b, {(a.x + b.x) / 2 + off, (a.y + b.y) / 2}});
  }
  return {large, close};
}
// END HIDDEN

// Directed edges along both axes and along two diagonals, each in both directions.
inline std::vector<EdgeCase> directions() {
  EdgeCase along{"the edges of a clockwise rectangle and its diagonals, both ways", {}};
  for (const auto& [x, y] : {std::array{4.0, 0.0},
                             {0.0, 3.0},
                             {-4.0, 0.0},
                             {0.0, -3.0},
                             {4.0, 3.0},
                             {-4.0, -3.0},
                             {4.0, -3.0},
                             {-4.0, 3.0}})
    along.samples.push_back({at(5, 5), at(5 + x, 5 + y), at(0, 0)});
  return {along};
}

// BEGIN HIDDEN
inline std::vector<EdgeCase> more_directions() {
  EdgeCase almost{"edges that are one step away from horizontal", {}},
      any{"edges in random directions", {}};
  for (const int dx : {-70000, 70000}) {
    for (const int dy : {-1, 0, 1})
      almost.samples.push_back({SnappedVertex{40, 9}, {40 + dx, 9 + dy}, {}});
  }
  Random random = glassbox::labs::varied(64);
  for (int i = 0; i < 40; ++i) any.samples.push_back(random_sample(random, 3 + 1000 * (i % 4)));
  return {almost, any};
}
// END HIDDEN

// ---- triangles (task 6.4) ----

struct CoverageCase {
  std::string what;
  std::vector<Triangle> triangles;
  PixelRect window{0, 0, 8, 8};
};

// A ring of triangles around a point; the last one has an edge in common with the first, so that
// every pixel inside the ring is covered once.
inline CoverageCase fan(int count, double centre, double radius) {
  CoverageCase c{std::to_string(count) + " triangles around a point", {}, {0, 0, 0, 0}};
  c.window.x1 = c.window.y1 = int(centre + radius) + 2;
  const auto ring = [&](int i) {
    // The ring is a polygon whose corners are computed only with + - * /, floor and integers, so
    // that it is the same on every machine.
    const double turn = 4.0 * (i % count) / count, side = turn - std::floor(turn);
    const double x = 1 - 2 * side, y = 1 - std::abs(x);
    const double forth[4][2] = {{x, y + 0.5}, {-y - 0.5, x}, {-x, -y - 0.5}, {y + 0.5, -x}};
    const auto& p = forth[int(turn) % 4];
    return at(centre + std::floor(radius * p[0] * 160) / 256,
              centre + std::floor(radius * p[1] * 160) / 256);
  };
  for (int i = 0; i < count; ++i) c.triangles.push_back({at(centre, centre), ring(i), ring(i + 1)});
  return c;
}

inline std::vector<CoverageCase> triangles() {
  return {
      {"Direct3D's rectangle, whose corners are pixel centres (C-43)",
       {{at(1.5, 1.5), at(3.5, 1.5), at(3.5, 5.5)}, {at(1.5, 1.5), at(3.5, 5.5), at(1.5, 5.5)}}},
      {"Direct3D's pair: 15 and 10 pixels (C-43)",
       {{at(0, 0), at(5, 0), at(5, 5)}, {at(0, 5), at(0, 0), at(5, 5)}}},
      {"one triangle in general position", {{at(0.75, 0.25), at(7.5, 3.125), at(2.25, 7.75)}}},
      {"two triangles of opposite winding side by side, and one without area (C-49, C-51)",
       {{at(1, 1), at(7, 2), at(2, 7)},
        {at(7, 2), at(2, 7), at(7, 7)},
        {at(0, 0), at(3, 3), at(6, 6)}}},
      {"a triangle across the left and the upper edge of the screen (C-48)",
       {{at(-5.75, -4.25), at(4.5, -1.5), at(-2.25, 6.5)}},
       {-7, -6, 6, 7}},
      {"edges that pass centres by one step",
       {{at(0.75, 0.75390625), at(7, 7.00390625), at(1, 7)},
        {at(0.75, 0.74609375), at(7, 6.99609375), at(7, 1)}}},
      {"a triangle larger than the window on all sides, and one with a corner in the window",
       {{at(-20, -12), at(50, 1.5), at(3.25, 60)}, {at(-20, -30), at(8.5, 7.5), at(40, -25)}},
       {2, 3, 11, 9}},
      fan(7, 8.5, 6)};
}

// BEGIN HIDDEN
inline CoverageCase jittered_grid(int cells, double cell, std::uint64_t seed) {
  CoverageCase c{"a grid of triangles whose vertices are shaken (C-45)", {}, {-1, -1, 0, 0}};
  c.window.x1 = c.window.y1 = int(cells * cell) + 2;
  Random random(seed);
  std::vector<SnappedVertex> vertices;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const SnappedVertex v = at(i * cell, j * cell);
      const std::int64_t shake = std::int64_t(cell * 64);
      vertices.push_back({v.x + std::int32_t(random.integer(-shake, shake)),
                          v.y + std::int32_t(random.integer(-shake, shake))});
    }
  }
  const auto vertex = [&](int i, int j) { return vertices[std::size_t(j * (cells + 1) + i)]; };
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const SnappedVertex a = vertex(i, j), b = vertex(i + 1, j), d = vertex(i, j + 1),
                          e = vertex(i + 1, j + 1);
      c.triangles.push_back({a, b, e});
      c.triangles.push_back((i + j) % 2 ? Triangle{a, e, d} : Triangle{a, d, e});
    }
  }
  return c;
}

inline std::vector<CoverageCase> more_triangles() {
  std::vector<CoverageCase> all{jittered_grid(12, 2.5, glassbox::labs::varied_seed(65)),
                                jittered_grid(9, 3.25, glassbox::labs::varied_seed(66))};
  for (const int count : {3, 5, 16, 61}) all.push_back(fan(count, 10.5, 7));
  Random random = glassbox::labs::varied(67);
  for (int k = 0; k < 3; ++k) {
    CoverageCase lattice{"triangles with vertices on pixel centres (C-43)", {}};
    for (int i = 0; i < 60; ++i) {
      Triangle t;
      for (SnappedVertex& v : t) {
        const double x = double(random.integer(0, 7)) + 0.5, y = double(random.integer(0, 7)) + 0.5;
        v = at(x, y);
      }
      lattice.triangles.push_back(t);
    }
    all.push_back(lattice);
  }
  all.push_back({"slivers one step wide (C-47)",
                 {{SnappedVertex{10, 128}, {4000, 128}, {4000, 129}},
                  {SnappedVertex{128, 20}, {129, 4000}, {128, 4000}},
                  {SnappedVertex{0, 1}, {4096, 4096}, {4095, 4096}}},
                 {0, 0, 16, 16}});
  all.push_back(
      {"a triangle of 2^16 pixels, seen through a window far from the origin (C-50)",
       {{SnappedVertex{-0x7fff80, -0x7ff123}, {0x7fff01, 0x7ffe00}, {-0x7f0000, 0x7fffff}}},
       {32600, 32580, 32624, 32604}});
  return all;
}
// END HIDDEN

// ---- polygons (task 6.5) ----

struct PolygonsCase {
  const char* what;
  std::vector<std::vector<SnappedVertex>> polygons;
};

inline std::vector<PolygonsCase> polygons() {
  return {
      {"convex polygons, an arrow that begins at each of its vertices in turn, and a polygon that "
       "crosses itself",
       {{at(0, 0), at(4, 0), at(4, 4), at(0, 4)},
        {at(0, 4), at(4, 4), at(4, 0), at(0, 0), at(-1, 2)},
        {at(1, 1), at(4, 0), at(0, 0), at(0, 4)},
        {at(0, 4), at(1, 1), at(4, 0), at(0, 0)},
        {at(0, 0), at(0, 4), at(1, 1), at(4, 0)},
        {at(4, 0), at(0, 0), at(0, 4), at(1, 1)},
        {at(0, 0), at(2, 2), at(2, 0), at(0, 2)}}},
      // The fan from vertex 0 of the first polygon has a triangle with a doubled area of exactly
      // 2^31, the smallest number that does not fit a signed integer of 32 bits; in the fan from
      // vertex 1 both doubled areas are smaller.
      {"convex polygons larger than 2^31 steps squared, and one of the largest size, bent inwards",
       {{at(0, 0), at(256, 0), at(192, 128), at(0, 96)},
        {at(0, 0), at(0, 96), at(192, 128), at(256, 0)},
        {at(-65535, -65535), at(65535, -65535), at(65535, 65535), at(-65535, 65535)},
        {at(-65535, 0), at(0, 0.00390625), at(65535, 0), at(0, 65535)}}}};
}

// BEGIN HIDDEN
inline std::vector<PolygonsCase> thin_polygons() {
  Random random = glassbox::labs::varied(68);
  PolygonsCase thin{
      "thin polygons that are not quite convex, because the snap has moved their corners", {}},
      turned = thin;
  for (int i = 0; i < 60; ++i) {
    const int count = int(random.integer(4, 9));
    std::vector<SnappedVertex> polygon;
    for (int k = 0; k < count; ++k) {  // the vertices are on a flat arc; the chord closes it
      const std::int32_t x = k * (count - 1 - k);
      polygon.push_back({1000 * k, -x / 6 + std::int32_t(random.integer(0, 1))});
    }
    thin.polygons.push_back(polygon);
    turned.polygons.emplace_back(polygon.rbegin(), polygon.rend());
  }
  return {thin, turned};
}
// END HIDDEN

// ---- tiles (task 6.6) ----

struct TileCase {
  const char* what;
  Triangle triangle;
  std::vector<PixelRect> tiles;  // of one size
};

// Square tiles, `side` pixels wide.
inline TileCase tiling(const char* what, const Triangle& t, int side, const PixelRect& screen) {
  TileCase c{what, t, {}};
  for (int y = screen.y0; y < screen.y1; y += side) {
    for (int x = screen.x0; x < screen.x1; x += side) c.tiles.push_back({x, y, x + side, y + side});
  }
  return c;
}

inline std::vector<TileCase> tilings() {
  const PixelRect screen{0, 0, 64, 64};
  return {tiling("a large triangle and tiles of 8 x 8", {at(3, 2), at(61, 20.5), at(11, 63)}, 8,
                 screen),
          tiling("a thin diagonal triangle: its box has many tiles, the triangle few",
                 {at(1, 1), at(63, 60), at(60, 63)}, 8, screen),
          tiling("edges through the centres at the tiles' borders (C-53)",
                 {at(8.5, 8.5), at(47.5, 8.5), at(8.5, 47.5)}, 8, screen),
          tiling("the triangle that is the other half of the square",
                 {at(47.5, 47.5), at(8.5, 47.5), at(47.5, 8.5)}, 8, screen),
          tiling("a thin triangle between the corners of its tiles",
                 {at(1, 4), at(62, 28), at(62.5, 29)}, 8, screen),
          tiling("edges that pass the centres at the tiles' borders by one step",
                 {at(7.49609375, 7.49609375), at(-32, 7.49609375), at(7.49609375, -32)}, 8,
                 {0, 0, 16, 16})};
}

// BEGIN HIDDEN
inline std::vector<TileCase> more_tilings() {
  const PixelRect screen{-16, -16, 48, 48};
  return {tiling("counter-clockwise", {at(8.5, 8.5), at(8.5, 47.5), at(47.5, 8.5)}, 8, screen),
          tiling("upside down", {at(39.5, 39.5), at(0.5, 39.5), at(39.5, 0.5)}, 8, screen),
          tiling("tiles of one pixel", {at(0.5, 0.5), at(7.5, 3.5), at(2, 8)}, 1, {-1, -1, 10, 10}),
          tiling("tiles of 16 x 16 and an edge just outside their centres",
                 {SnappedVertex{16 * 256 + 127, -9000}, {16 * 256 + 129, 12000}, {-3000, 900}}, 16,
                 screen),
          tiling("a triangle of 2^16 pixels (C-50)",
                 {SnappedVertex{-0x7fff80, -0x7ff123}, {0x7fff01, 0x7ffe00}, {-0x7f0000, 0x7fffff}},
                 8, {32600, 32580, 32632, 32612})};
}
// END HIDDEN

}  // namespace inputs
}  // namespace lab_06
