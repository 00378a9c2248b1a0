// The inputs of lab 14's test cases: for the runner, which calls the student's functions, and for
// the checks, which compute the expected answers.
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <glassbox/base/random.h>

#include "labs/framework/varied_inputs.h"
#include "student.h"

namespace lab_14 {
// A namespace of its own: a function or type of yours in student.cpp may have the name of one of
// these, and does not replace it.
inline namespace inputs {

// ---- cells (task 14.1) ----

struct CellCase {
  std::string what;
  unsigned inside = 0;
};

inline std::vector<CellCase> cells() {
  return {{"one corner", 1},
          {"the two corners of an edge", 0b00000011},
          {"the lower half", 0b00001111},
          {"all corners except one", 255 - 16},
          {"two opposite corners of a face (C-95)", 0b00001001},
          {"all corners except two opposite ones of a face (C-95)", 255 - 0b00001001},
          {"opposite corners of the cell", 0b10000001}};
}
// BEGIN HIDDEN
// All 256 cells, sixteen in a test case: the report names the first cell that is wrong.
struct CellsCase {
  std::string what;
  unsigned first = 0;
};
inline std::vector<CellsCase> hidden_cells() {
  std::vector<CellsCase> all;
  for (unsigned first = 0; first < 256; first += 16)
    all.push_back(
        {"corners " + std::to_string(first) + " to " + std::to_string(first + 15), first});
  return all;
}
// END HIDDEN

// ---- edges (task 14.2) ----

struct EdgeCase {
  std::string what;
  double from = 0, to = 0, level = 0;
};

inline std::vector<EdgeCase> edges() {
  return {{"half way", -1, 1, 0},
          {"a crossing a third of the edge away from the inside end", 2, -4, 0},
          {"another level", 1, 5, 2},
          {"an outside end nearly at the level", -0.0001, 1, 0},
          {"an inside end exactly at the level (C-96)", 0, -3, 0},
          {"an edge at the border of the lattice", -INFINITY, 1, 0}};
}
// BEGIN HIDDEN
inline EdgeCase random_edge(glassbox::Random& random) {
  const double level = random.between(-10, 10), in = level + random.between(0, 5),
               out = level - random.between(0.001, 5);
  const bool up = random.integer(0, 1) == 0;
  return {"any values", up ? out : in, up ? in : out, level};
}
inline std::vector<EdgeCase> hidden_edges() {
  glassbox::Random random = glassbox::labs::varied(141);
  std::vector<EdgeCase> all{
      {"the second end is inside and exactly at the level (C-96)", -7, 3, 3},
      {"an edge whose second end is outside the lattice", 4, -INFINITY, 1},
      {"large values", 0x1p60, -0x1p58, 0x1p40},
      {"one value above the level by one rounding step", 1 + 0x1p-52, 0.5, 1}};
  for (int i = 0; i < 6; ++i) all.push_back(random_edge(random));
  return glassbox::labs::with_varied(std::move(all), 142, 4, random_edge);
}
// END HIDDEN

// ---- layered images (task 14.3) ----

struct Edit {
  bool comes = true;
  int id = 0;
  std::vector<Covered> covered;
};

struct EditCase {
  std::string what;
  std::size_t pixels = 1;
  std::vector<Edit> edits;
};

inline std::vector<EditCase> edits() {
  return {{"one polygon", 3, {{true, 5, {{0, 2.0}, {2, 3.0}}}}},
          {"the second polygon is nearer than the first",
           2,
           {{true, 1, {{0, 4.0}, {1, 4.0}}}, {true, 2, {{0, 3.0}}}}},
          {"the polygon in front is removed",
           1,
           {{true, 1, {{0, 4.0}}}, {true, 2, {{0, 3.0}}}, {false, 2, {{0, 3.0}}}}},
          {"the polygon behind is removed (C-97)",
           1,
           {{true, 1, {{0, 4.0}}}, {true, 2, {{0, 3.0}}}, {false, 1, {{0, 4.0}}}}},
          {"equally near polygons",
           1,
           {{true, 7, {{0, 2.0}}}, {true, 3, {{0, 2.0}}}, {true, 5, {{0, 2.0}}}}}};
}
// BEGIN HIDDEN
inline EditCase random_edits(glassbox::Random& random) {
  EditCase made{"any edits (C-97)", 12, {}};
  std::vector<std::vector<Covered>> there(20);
  for (int i = 0; i < 200; ++i) {
    const int id = int(random.integer(0, 19));
    std::vector<Covered>& mine = there[std::size_t(id)];
    if (!mine.empty()) {
      made.edits.push_back({false, id, std::exchange(mine, {})});
      continue;
    }
    for (std::size_t pixel = 0; pixel < made.pixels; ++pixel) {
      if (random.integer(0, 1) == 0) mine.push_back({pixel, double(random.integer(1, 9))});
    }
    if (!mine.empty()) made.edits.push_back({true, id, mine});
  }
  return made;
}
inline std::vector<EditCase> hidden_edits() {
  glassbox::Random random = glassbox::labs::varied(143);
  return glassbox::labs::with_varied(
      std::vector<EditCase>{random_edits(random),
                            random_edits(random),
                            {"an id that is not there is removed",
                             1,
                             {{true, 1, {{0, 4.0}}}, {false, 9, {{0, 4.0}}}}},
                            {"a polygon is added again, nearer",
                             1,
                             {{true, 1, {{0, 4.0}}},
                              {true, 2, {{0, 3.0}}},
                              {false, 1, {{0, 4.0}}},
                              {true, 1, {{0, 1.0}}}}}},
      144, 2, random_edits);
}
// END HIDDEN

// ---- views (task 14.4) ----

struct ViewCase {
  std::string what;
  Vector direction{};
  std::array<Vector, 3> views{};
  std::array<bool, 3> sees{true, true, true};
};

// The unit vector (x, y, z) / length. The caller gives the length, for vectors whose quotients have
// few digits.
inline Vector along(double x, double y, double z, double length) {
  return {x / length, y / length, z / length};
}
inline std::array<Vector, 3> three_views() {
  return {along(0, 0, 1, 1), along(3, 0, 4, 5), along(0, 3, 4, 5)};
}

inline std::vector<ViewCase> views_around() {
  return {{"the eye's direction is that of the first view", along(0, 0, 1, 1), three_views()},
          {"the eye's direction is in the middle of the triangle of views",
           along(1, 1, 4.24264068711928515, 4.47213595499957939), three_views()},
          {"the eye's direction is on a side of the triangle of views",
           along(3, 0, 9, 9.48683298050513768), three_views()},
          {"three views, of which one does not see the polygon",
           along(1, 2, 9, 9.2736184954957037),
           three_views(),
           {true, false, true}},
          {"the eye's direction is that of a view that does not see the polygon (C-98)",
           along(3, 0, 4, 5),
           three_views(),
           {true, false, true}},
          {"no view sees the polygon (C-98)",
           along(1, 2, 9, 9.2736184954957037),
           three_views(),
           {false, false, false}}};
}
// BEGIN HIDDEN
inline Vector random_direction(glassbox::Random& random) {
  for (;;) {
    const Vector v{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if (length > 0.2) return along(v[0], v[1], v[2], length);
  }
}
inline double volume_of(const std::array<Vector, 3>& v) {
  return v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) +
         v[0][1] * (v[1][2] * v[2][0] - v[1][0] * v[2][2]) +
         v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]);
}
inline ViewCase random_views(glassbox::Random& random) {
  for (;;) {
    ViewCase made{"any views"};
    for (Vector& view : made.views) view = random_direction(random);
    if (std::abs(volume_of(made.views)) < 0.1) continue;
    // The direction is a weighted sum of the views, and is between them in most cases.
    Vector v{};
    for (const Vector& view : made.views) {
      const double w = random.between(-0.1, 1);
      for (std::size_t i = 0; i < 3; ++i) v[i] += w * view[i];
    }
    const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if (length < 0.2) continue;
    made.direction = along(v[0], v[1], v[2], length);
    for (bool& sees : made.sees) sees = random.integer(0, 3) > 0;
    return made;
  }
}
inline std::vector<ViewCase> hidden_views_around() {
  glassbox::Random random = glassbox::labs::varied(145);
  std::vector<ViewCase> all{
      {"clockwise views",
       along(1, 2, 9, 9.2736184954957037),
       {three_views()[0], three_views()[2], three_views()[1]}},
      {"the eye's direction is beside the triangle of views", along(-3, 0, 4, 5), three_views()},
      {"the eye's direction is beside the triangle, and the nearest view does not see the polygon",
       along(-3, 0, 4, 5),
       three_views(),
       {false, true, true}},
      {"the eye's direction is opposite to all views", along(0, 0, -1, 1), three_views()},
      {"equally near views without a weight",
       along(-1, -1, 4.24264068711928515, 4.47213595499957939),
       three_views(),
       {false, true, true}},
      {"only the last view sees the polygon",
       along(1, 2, 9, 9.2736184954957037),
       three_views(),
       {false, false, true}}};
  for (int i = 0; i < 8; ++i) all.push_back(random_views(random));
  return glassbox::labs::with_varied(std::move(all), 146, 4, random_views);
}
// END HIDDEN

// ---- bands (tasks 14.5, 14.6) ----

struct BandCase {
  std::string what;
  Pixels pixels;
  std::size_t k = 1;
  // What task 14.6 gets. It is not the student's answer to task 14.5, so that the tasks do not
  // depend on each other.
  std::vector<double> mean = {};
  Matrix vectors = {};
};

inline std::vector<BandCase> bands() {
  return {
      {"two bands that depend on each other",
       {{1, 2}, {2, 4}, {3, 6}, {6, 12}},
       1,
       {3, 6},
       {{0.44721359549995793, 0.89442719099991586}, {0.89442719099991586, -0.44721359549995793}}},
      {"a band that does not change",
       {{5, 1}, {5, 2}, {5, 4}},
       1,
       {5, 2.3333333333333335},
       {{0, 1}, {1, 0}}},
      {"a square: no direction is better than another",
       {{1, 1}, {1, -1}, {-1, 1}, {-1, -1}},
       2,
       {0, 0},
       {{1, 0}, {0, 1}}},
      {"four bands",
       {{9, 8, 1, 0}, {7, 7, 2, 1}, {1, 2, 8, 9}, {0, 1, 9, 9}, {4, 4, 5, 5}},
       2,
       {4.2, 4.4, 5, 4.8},
       {{0.51831369521196613, 0.41237775127634874, -0.47858191346189427, -0.57641552348555924},
        {0.54229655280936628, 0.29902612671532364, -0.093914461508953495, 0.77953697684727763},
        {0.65443524714038448, -0.4700131307636411, 0.5544973272771776, -0.2081703106894236},
        {-0.09476217318687509, 0.72084368812083932, 0.67429380841670372, -0.12935365383376266}}},
      {"no components",
       {{1, 2, 3}, {3, 2, 0}, {2, 2, 6}},
       0,
       {2, 2, 3},
       {{-0.17842480549373665, 0, 0.98395355011531027},
        {0.98395355011531027, 0, 0.17842480549373665},
        {0, 1, 0}}}};
}
// BEGIN HIDDEN
// Pixels with `bands` bands. Each band of a pixel is a mixture of the same `sources` random values,
// plus `offset` and a little noise.
inline Pixels mixed_bands(glassbox::Random& random, int count, std::size_t bands,
                          std::size_t sources, double offset) {
  Matrix mix(bands, std::vector<double>(sources));
  for (auto& row : mix) {
    for (double& each : row) each = random.between(-1, 1);
  }
  Pixels pixels;
  for (int n = 0; n < count; ++n) {
    std::vector<double> source, pixel;
    for (std::size_t s = 0; s < sources; ++s)
      source.push_back(random.between(-8, 8) / double(s + 1));
    for (std::size_t b = 0; b < bands; ++b) {
      double value = offset + random.between(-0.01, 0.01);
      for (std::size_t s = 0; s < sources; ++s) value += mix[b][s] * source[s];
      pixel.push_back(value);
    }
    pixels.push_back(std::move(pixel));
  }
  return pixels;
}

inline std::vector<double> mean_of(const Pixels& pixels) {
  std::vector<double> mean(pixels.front().size(), 0);
  for (const auto& x : pixels) {
    for (std::size_t i = 0; i < x.size(); ++i) mean[i] += x[i] / double(pixels.size());
  }
  return mean;
}
inline Matrix vectors_of(const Pixels& pixels, const std::vector<double>& mean) {
  const std::size_t bands = mean.size();
  Matrix scatter(bands, std::vector<double>(bands, 0));
  for (const auto& x : pixels) {
    for (std::size_t i = 0; i < bands; ++i) {
      for (std::size_t j = 0; j < bands; ++j) scatter[i][j] += (x[i] - mean[i]) * (x[j] - mean[j]);
    }
  }
  return eigen_of(scatter).vectors;
}
inline BandCase mixed_case(const char* what, Pixels pixels, std::size_t k) {
  auto mean = mean_of(pixels);
  Matrix vectors = vectors_of(pixels, mean);
  return {what, std::move(pixels), k, std::move(mean), std::move(vectors)};
}
inline BandCase random_bands(glassbox::Random& random) {
  return mixed_case("any bands", mixed_bands(random, 60, 6, 3, 0), 3);
}
inline std::vector<BandCase> hidden_bands() {
  glassbox::Random random = glassbox::labs::varied(147);
  return glassbox::labs::with_varied(
      std::vector<BandCase>{
          random_bands(random),
          mixed_case("values of a million", mixed_bands(random, 40, 4, 2, 1e6), 2),
          mixed_case("all components", mixed_bands(random, 30, 5, 5, 3), 5),
          mixed_case("seven bands, of which one component is kept",
                     mixed_bands(random, 50, 7, 1, -20), 1)},
      148, 2, random_bands);
}
// END HIDDEN

}  // namespace inputs
}  // namespace lab_14
