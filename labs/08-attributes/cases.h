// The inputs of lab 8's test cases: for the runner, which calls the student's functions, and for
// the checks, which compute the expected answers.
#pragma once

#include <vector>

#include "labs/framework/varied_inputs.h"
#include "student.h"

namespace lab_08 {
// A namespace of its own: a function or type of yours in student.cpp may have the name of one of
// these, and does not replace it.
inline namespace inputs {

// ---- pixels (task 8.1) ----

struct PixelCase {
  const char* what;
  PixelOfTriangle at;
  const char* command = "";  // a command that shows a similar case
};

inline std::vector<PixelCase> pixels() {
  return {
      {"all corners at the same distance",
       {{1, 2, 5}, {0.25f, 0.25f, 0.25f}, {{{0, 0}, {1, 0}, {0, 1}}}}},
      {"a wall whose far end is four times as far as its near end",
       {{32768, 32768, 65536}, {1, 0.25f, 0.5f}, {{{0, 0}, {1, 0}, {0.5f, 1}}}}},
      {"in vertex 2", {{0, 0, 977}, {0.5f, 3, 0.125f}, {{{0, 0}, {1, 0}, {0.3f, 0.7f}}}}},
      {"a wall whose far end is a hundred times as far as its near end (C-65)",
       {{9000, 30001, 26535}, {1, 0.01f, 0.013f}, {{{0, 8}, {256, 8}, {250, 0}}}},
       "glassbox study extremes --case C-65"},
      {"texture coordinates around two thousand (C-67)",
       {{23331, 23894, 84998}, {1, 0.5f, 0.2f}, {{{2000.25f, 0}, {2001, 0.25f}, {2000.5f, 1}}}},
       "glassbox study extremes --case C-67"},
      {"a texture coordinate that is the same everywhere",
       {{3, 70, 11}, {0.7f, 0.01f, 0.3f}, {{{0.1f, 0.2f}, {0.1f, 0.4f}, {0.1f, 0.9f}}}}},
  };
}
// BEGIN HIDDEN
inline std::vector<PixelCase> hidden_pixels() {
  return glassbox::labs::with_varied(
      std::vector<PixelCase>{
          {"1/w from 1000 to 10^-6 (C-66)",
           {{123456, 654321, 987654321}, {1e3f, 1, 1e-6f}, {{{0, 0}, {1024, 0}, {1024, 512}}}},
           "glassbox study extremes --case C-66"},
          {"the far end of a floor (C-65)",
           {{7, 12, 4567890}, {0.25f, 0.25f, 0.00025f}, {{{0, 0}, {0, 1}, {1, 0.5f}}}},
           "glassbox study extremes --case C-65"},
          {"coordinates around a million (C-67)",
           {{10007, 43333, 35008},
            {1, 0.5f, 0.2f},
            {{{1e6f, -1e6f}, {1000001, -1000001}, {1000003, -1000000}}}},
           "glassbox study extremes --case C-67"},
          {"edge functions of 2^50",
           {{1125899906842623, 562949953421313, 281474976710657},
            {0.3f, 0.02f, 7},
            {{{-3, 0.25f}, {9, 0.75f}, {2, 0.5f}}}}},
      },
      81, 3, [](glassbox::Random& random) {
        PixelCase c{"anywhere", {}};
        for (auto& edge : c.at.edges) edge = random.integer(1, 1 << 24);
        for (auto& w : c.at.inverse_w) w = float(random.between(0.01, 1));
        for (auto& coordinates : c.at.texcoords) {
          for (auto& each : coordinates) each = float(random.between(-9, 9));
        }
        return c;
      });
}
// END HIDDEN

// ---- rows of pixels (tasks 8.2 and 8.3) ----

struct SpanCase {
  const char* what;
  Line line;
  int every;
};

inline std::vector<SpanCase> spans() {
  return {
      {"a row at one distance, along which u is linear", {0, 16, 1, 1, 8}, 4},
      {"a wall that is four times as far at its end", {0, 16, 1, 0.25, 16}, 8},
      {"a division for each pixel", {3, -5, 0.5, 0.1, 6}, 1},
      {"a last span of 4 pixels", {0, 20, 1, 0.1, 20}, 8},
  };
}
// BEGIN HIDDEN
inline std::vector<SpanCase> hidden_spans() {
  return glassbox::labs::with_varied(
      std::vector<SpanCase>{
          {"a wall that is a hundred times as far at its end (C-65)", {0, 256, 1, 0.01, 256}, 32},
          {"affine: one span", {-10, 90, 0.02, 1, 64}, 64},
          {"a last span of one pixel", {100, 7, 0.3, 0.9, 33}, 16},
      },
      82, 3, [](glassbox::Random& random) {
        const double first = random.between(-50, 50), last = random.between(-50, 50);
        const double near = random.between(0.1, 1), far = random.between(0.1, 1);
        const int pixels = int(random.integer(17, 99));
        return SpanCase{"anywhere", {first, last, near, far, pixels}, int(random.integer(2, 16))};
      });
}
// END HIDDEN

struct ChoiceCase {
  Line line;
  double tolerance;
};

inline std::vector<ChoiceCase> choices() {
  return {
      {{0, 256, 1, 1, 256}, 0.1},
      {{0, 256, 1, 1 / 1.41, 256}, 0.2},
      {{0, 256, 1, 0.5, 256}, 0.5},
      {{0, 256, 1, 0.1, 256}, 0.05},
  };
}
// BEGIN HIDDEN
inline std::vector<ChoiceCase> hidden_choices() {
  return {
      {{0, 256, 0.2, 1, 256}, 4},
      {{512, 0, 1, 0.01, 1920}, 2},
      {{5, 8, 0.37, 0.36, 100}, 0.001},
      {{0, 1, 1, 0.25, 7}, 1},
  };
}
// END HIDDEN

// ---- footprints (task 8.4) ----

struct FootprintCase {
  const char* what;
  std::array<TexturedVertex, 3> triangle;
  double x, y;
  int width, height;
};

inline std::vector<FootprintCase> footprints() {
  return {
      {"a triangle that faces the eye, with two texels per pixel",
       {{{0, 0, 1, 0, 0}, {64, 0, 1, 1, 0}, {0, 64, 1, 0, 1}}},
       16.5,
       20.5,
       128,
       128},
      {"a wall whose far end is eight times as far as its near end",
       {{{10, 20, 1, 0, 0}, {210, 90, 0.125, 1, 0}, {10, 180, 1, 0, 1}}},
       100.5,
       90.5,
       256,
       256},
      {"a floor with the other winding",
       {{{20, 200, 0.5, 0, 0}, {220, 200, 0.5, 1, 0}, {100, 110, 0.02, 0.5, 12}}},
       96.5,
       140.5,
       64,
       64},
      {"texels larger than pixels, which need level 0",
       {{{0, 0, 1, 0, 0}, {100, 0, 0.5, 0.125, 0}, {0, 100, 0.75, 0, 0.0625}}},
       30.5,
       30.5,
       64,
       128},
  };
}
// BEGIN HIDDEN
inline std::vector<FootprintCase> hidden_footprints() {
  return {
      {"a texture sixteen times as wide as high",
       {{{5.25, 7.5, 1, 0, 0}, {150.75, 20, 0.3, 2, 0.5}, {40, 140.5, 0.6, 0.25, 3}}},
       60.5,
       50.5,
       1024,
       64},
      {"a triangle smaller than one texel, which needs the last level",
       {{{0, 0, 1, 0, 0}, {8, 0, 0.5, 90, 0}, {0, 8, 0.7, 0, 70}}},
       2.5,
       2.5,
       32,
       16},
      {"texture coordinates that do not change, so that there is one colour",
       {{{0, 0, 1, 0.3, 0.4}, {50, 3, 0.1, 0.3, 0.4}, {9, 60, 0.4, 0.3, 0.4}}},
       20.5,
       20.5,
       256,
       256},
      {"a wall whose far end is thirty times as far, with texture coordinates around a thousand "
       "(C-67)",
       {{{10, 10, 1, 1000, 1000}, {140, 60, 0.03125, 1008, 1000}, {10, 150, 1, 1000, 1001}}},
       110.5,
       60.5,
       512,
       512},
      {"a pixel at an outline, none of whose neighbours is on the triangle (C-69)",
       {{{40, 40, 0.5, 0, 0}, {41, 40, 0.5, 0.125, 0}, {40, 41, 0.25, 0, 0.25}}},
       40.5,
       40.5,
       128,
       128},
  };
}
// END HIDDEN

// ---- patches of Newell's teapot, with y up (tasks 8.5 and 8.6) ----

inline Patch teapot_body() {
  return {{{{{{1.5, 2.4, 0}, {1.5, 2.4, 0.84}, {0.84, 2.4, 1.5}, {0, 2.4, 1.5}}},
            {{{1.75, 1.875, 0}, {1.75, 1.875, 0.98}, {0.98, 1.875, 1.75}, {0, 1.875, 1.75}}},
            {{{2, 1.35, 0}, {2, 1.35, 1.12}, {1.12, 1.35, 2}, {0, 1.35, 2}}},
            {{{2, 0.9, 0}, {2, 0.9, 1.12}, {1.12, 0.9, 2}, {0, 0.9, 2}}}}}};
}
// The knob of the lid. All four points of its first row are the same point, a pole.
inline Patch teapot_knob() {
  return {{{{{{0, 3.15, 0}, {0, 3.15, 0}, {0, 3.15, 0}, {0, 3.15, 0}}},
            {{{0.8, 3.15, 0}, {0.8, 3.15, 0.45}, {0.45, 3.15, 0.8}, {0, 3.15, 0.8}}},
            {{{0, 2.85, 0}, {0, 2.85, 0}, {0, 2.85, 0}, {0, 2.85, 0}}},
            {{{0.2, 2.7, 0}, {0.2, 2.7, 0.112}, {0.112, 2.7, 0.2}, {0, 2.7, 0.2}}}}}};
}
inline Patch flat_square() {
  Patch p;
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t i = 0; i < 4; ++i) p.rows[j][i] = {double(i), 0.5, -2 * double(j)};
  }
  return p;
}
// BEGIN HIDDEN
inline Patch teapot_spout() {
  return {{{{{{1.7, 1.425, 0}, {1.7, 1.425, 0.66}, {1.7, 0.6, 0.66}, {1.7, 0.6, 0}}},
            {{{2.6, 1.425, 0}, {2.6, 1.425, 0.66}, {3.1, 0.825, 0.66}, {3.1, 0.825, 0}}},
            {{{2.3, 2.1, 0}, {2.3, 2.1, 0.25}, {2.4, 2.025, 0.25}, {2.4, 2.025, 0}}},
            {{{2.7, 2.4, 0}, {2.7, 2.4, 0.25}, {3.3, 2.4, 0.25}, {3.3, 2.4, 0}}}}}};
}
inline Patch teapot_bottom() {
  return {{{{{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}},
            {{{1.425, 0, 0}, {1.425, 0, -0.798}, {0.798, 0, -1.425}, {0, 0, -1.425}}},
            {{{1.5, 0.075, 0}, {1.5, 0.075, -0.84}, {0.84, 0.075, -1.5}, {0, 0.075, -1.5}}},
            {{{1.5, 0.15, 0}, {1.5, 0.15, -0.84}, {0.84, 0.15, -1.5}, {0, 0.15, -1.5}}}}}};
}
// A patch whose first row ends at the point where it begins. The row is not a pole, because its
// other points differ. In doubled_body(), only the first two points of the row are the same.
inline Patch looped_body() {
  Patch p = teapot_body();
  p.rows[0][3] = p.rows[0][0];
  return p;
}
inline Patch doubled_body() {
  Patch p = teapot_body();
  p.rows[0][1] = p.rows[0][0];
  return p;
}
// The body with other points in its first row: point i of the row is point from[i] of the original
// row.
inline Patch body_with_row(const std::array<std::size_t, 4>& from) {
  const Patch body = teapot_body();
  Patch p = body;
  for (std::size_t i = 0; i < 4; ++i) p.rows[0][i] = body.rows[0][from[i]];
  return p;
}
// END HIDDEN

struct PatchCase {
  const char* what;
  Patch patch;
  int level;
};
inline std::vector<PatchCase> patches() {
  return {
      {"a quarter of the teapot's body, one cell", teapot_body(), 1},
      {"a quarter of the teapot's body", teapot_body(), 3},
      {"the knob of its lid, which begins in a point", teapot_knob(), 4},
  };
}
// BEGIN HIDDEN
inline std::vector<PatchCase> hidden_patches() {
  return {
      {"the spout", teapot_spout(), 5},
      {"the bottom, which begins in a point", teapot_bottom(), 2},
      {"a flat square", flat_square(), 3},
      {"a first row that begins and ends at the same point, but is not a pole", looped_body(), 2},
      {"a first row that begins with one point twice", doubled_body(), 2},
      {"a first row that begins with one point three times", body_with_row({0, 0, 0, 3}), 2},
      {"a first row that ends with one point three times", body_with_row({0, 3, 3, 3}), 2},
      {"a first row of two points, each of them twice", body_with_row({0, 0, 3, 3}), 2},
      {"the body, finely", teapot_body(), 16},
  };
}
// END HIDDEN

// Which border of patch `b` is the last row (v = 1) of patch `a`. The order is opposite: position i
// along the row of `a` is position level - i along the border of `b`.
enum class Border { kFirstRow, kFirstColumn, kLastColumn };
struct SeamCase {
  const char* what;
  Patch a, b;
  Border border;
  int level;
};
inline SeamCase seam(const char* what, const Patch& a, Border border, int level) {
  Patch b;
  for (std::size_t t = 0; t < 4; ++t) {
    const auto& p = a.rows[3][3 - t];
    for (std::size_t k = 0; k < 4; ++k) {
      const double away = double(k);
      const Point<Object, double> q{p.x + 0.3 * away, p.y - 0.5 * away, p.z - 0.1 * away};
      if (border == Border::kFirstRow) b.rows[k][t] = q;
      if (border == Border::kFirstColumn) b.rows[t][k] = q;
      if (border == Border::kLastColumn) b.rows[t][3 - k] = q;
    }
  }
  return {what, a, b, border, level};
}
inline std::vector<SeamCase> seams() {
  return {
      seam("below the body, first row", teapot_body(), Border::kFirstRow, 7),
      seam("below the body, first column", teapot_body(), Border::kFirstColumn, 12),
  };
}
// BEGIN HIDDEN
inline std::vector<SeamCase> hidden_seams() {
  return {
      seam("beside the spout, last column", teapot_spout(), Border::kLastColumn, 11),
      seam("below the bottom, first column", teapot_bottom(), Border::kFirstColumn, 23),
  };
}
// END HIDDEN

struct LevelCase {
  const char* what;
  Patch patch;
  double px_per_unit, tolerance_px;
};
inline std::vector<LevelCase> levels() {
  return {
      {"the body, to a quarter of a pixel", teapot_body(), 140, 0.25},
      {"the body, seen from far away", teapot_body(), 8, 0.25},
      {"the knob, to a pixel", teapot_knob(), 140, 1},
      {"a flat square", flat_square(), 5000, 0.01},
  };
}
// BEGIN HIDDEN
inline std::vector<LevelCase> hidden_levels() {
  return {
      {"the spout, to half a pixel", teapot_spout(), 200, 0.5},
      {"the bottom, to a quarter of a pixel", teapot_bottom(), 140, 0.25},
      {"the spout, smaller than a pixel", teapot_spout(), 0.1, 1},
      {"a surface that would need more than 256 cells along a side", teapot_spout(), 1e6, 0.01},
  };
}
// END HIDDEN

}  // namespace inputs
}  // namespace lab_08
