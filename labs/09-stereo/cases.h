// The inputs of lab 9's test cases: for the runner, which calls the student's functions, and for
// the checks, which compute the expected answers.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <glassbox/base/random.h>

#include "labs/framework/varied_inputs.h"
#include "student.h"

namespace lab_09 {
// A namespace of its own: a function or type of yours in student.cpp may have the name of one of
// these, and does not replace it.
inline namespace inputs {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

// ---- projections (task 9.1) ----

struct ProjectionCase {
  const char* what;
  Transform<Clip, Eye> centre;
  Pair pair;
};

// A perspective projection to x' = scale x + off_middle z, y' = scale y, z' = a z + b and w' = -z.
inline Transform<Clip, Eye> perspective_matrix(double scale, double off_middle, double a,
                                               double b) {
  Transform<Clip, Eye> m;
  m.at(0, 0) = m.at(1, 1) = scale;
  m.at(0, 2) = off_middle;
  m.at(2, 2) = a;
  m.at(2, 3) = b;
  m.at(3, 2) = -1;
  m.at(3, 3) = 0;
  return m;
}
inline Transform<Clip, Eye> parallel_matrix(double scale, double off_middle, double a, double b) {
  Transform<Clip, Eye> m;
  m.at(0, 0) = m.at(1, 1) = scale;
  m.at(0, 3) = off_middle;
  m.at(2, 2) = a;
  m.at(2, 3) = b;
  return m;
}

// Projections with the near plane at 1 and the far plane at 5, or at 2 and at 18.
inline std::vector<ProjectionCase> projections() {
  return {
      {"a window at 4", perspective_matrix(2, 0, -1.25, -1.25), {0.5, 4}},
      {"numbers with many digits", perspective_matrix(1.7, 0, -1.125, -2.25), {0.03, 10}},
      {"no separation (C-71)", perspective_matrix(1.3, 0, -1.25, -1.25), {0, 4}},
  };
}
// BEGIN HIDDEN
inline std::vector<ProjectionCase> hidden_projections() {
  return glassbox::labs::with_varied(
      std::vector<ProjectionCase>{
          {"a picture whose middle is not on the gaze",
           perspective_matrix(1.9, 0.3, -1.125, -2.25),
           {0.07, 3}},
          {"a parallel projection", parallel_matrix(0.21, -0.4, -0.0625, -0.125), {0.3, 11}},
          {"reversed depth, an infinite far plane",
           perspective_matrix(2.4, 0, 0, 0.1),
           {0.033, 1.7}},
          {"a window at infinity: parallel eyes without skew",
           perspective_matrix(1.4, 0, -1.25, -1.25),
           {0.2, kInfinity}},
      },
      91, 3, [](glassbox::Random& random) {
        const double size = random.between(1, 3), off = random.between(-0.3, 0.3);
        const double half = random.between(0.01, 0.5);
        return ProjectionCase{"any eyes",
                              perspective_matrix(size, off, -1.125, -2.25),
                              {half, random.between(1, 20)}};
      });
}
// END HIDDEN

// Two parallel eyes, without skew: their pictures are drawn with more columns at the sides, then
// shifted against each other and cropped. The shift s scale width / window, where s is half the
// separation, is a whole number of pixels.
struct CropCase {
  const char* what;
  double scale;
  Pair pair;
  int width;
  std::vector<Point<Eye, double>> points;
};
inline std::vector<Point<Eye, double>> crop_points() {
  return {{0, 0, -10},  {1, 2, -10},   {-3, 1, -4.5}, {2.5, -1, -7},
          {30, 4, -80}, {-0.5, 0, -2}, {7, 7, -1000}};
}
inline std::vector<CropCase> crops() {
  return {{"cut by 32 columns", 1, {0.5, 10}, 640, crop_points()}};
}
// BEGIN HIDDEN
inline std::vector<CropCase> hidden_crops() {
  return {{"cut by 11 columns", 1, {0.25, 8}, 352, crop_points()},
          {"a narrow view, cut by 60 columns", 3, {0.125, 2}, 320, crop_points()}};
}
// END HIDDEN

// ---- parallax (task 9.2) ----

struct ParallaxCase {
  const char* what;
  Pair pair;
  Picture picture;
  double distance;
};
inline std::vector<ParallaxCase> distances() {
  const Pair pair{0.05, 4};
  const Picture picture{1.8, 1280};
  return {{"a distance in front of the window", pair, picture, 2.5},
          {"behind it", pair, picture, 9},
          {"at the window (C-70)", pair, picture, 4},
          {"infinitely far", pair, picture, kInfinity},
          {"a distance just behind the window", pair, picture, 4.000001}};
}
// BEGIN HIDDEN
inline std::vector<ParallaxCase> hidden_distances() {
  const Pair pair{0.03, 10};
  const Picture picture{1.37, 1920};
  return glassbox::labs::with_varied(
      std::vector<ParallaxCase>{
          {"near the eyes (C-73)", pair, picture, 0.1},
          {"a window distance with many digits", {0.07, 0.3}, picture, 1.1},
          {"a distance just in front of a far window", {3, 1e6}, picture, 999999.99999},
          {"far behind it", pair, picture, 1e9},
          {"parallel eyes without skew, for which everything is in front of the window",
           {0.03, kInfinity},
           picture,
           7},
          {"no separation (C-71)", {0, 10}, picture, 3},
          {"a small picture", pair, {1.37, 40}, 12},
          {"very large units", {3e199, 1e200}, picture, 2.5e200}},
      92, 3, [](glassbox::Random& random) {
        const double half = random.between(0.01, 0.5), window = random.between(1, 20);
        const double screen = random.between(1, 2);
        return ParallaxCase{"any eyes", {half, window}, {screen, 1280}, random.between(0.5, 50)};
      });
}
// END HIDDEN

// ---- triangles (task 9.3) ----

struct CullCase {
  std::string what;
  std::vector<std::string> names;
  std::vector<std::array<StereoPoint, 3>> triangles;
  void add(const std::string& name, const std::array<StereoPoint, 3>& triangle) {
    names.push_back(name);
    triangles.push_back(triangle);
  }
};

// A point at this distance, in the clip space of both eyes: y is in world units, and the left eye
// sees it at x + apart, the right eye at x - apart. The picture is a square with scale 1, the near
// plane is at 1 and the far plane at 65. w is the distance; a negative distance is behind the eye.
inline StereoPoint seen_at(double apart, double x, double y, double distance) {
  return {float(x + apart), float(x - apart), float(y), float((distance - 1) * 65 / 64),
          float(distance)};
}
// An upright triangle, 0.25 high, with all corners at the same distance.
inline std::array<StereoPoint, 3> upright(double apart, double x0, double x1, double y,
                                          double distance) {
  return {seen_at(apart, x0, y, distance), seen_at(apart, x1, y, distance),
          seen_at(apart, (x0 + x1) / 2, y + 0.25, distance)};
}

inline std::vector<CullCase> triangles() {
  CullCase all{"small triangles inside and outside the view volume", {}, {}};
  all.add("in the middle", upright(0.1, -1, 1, 0, 8));
  all.add("a triangle far to the left", upright(0.1, -30, -28, 0, 8));
  all.add("a triangle far to the right", upright(0.1, 28, 30, 0, 8));
  all.add("above", upright(0.1, -1, 1, 9, 8));
  all.add("below", upright(0.1, -1, 1, -9, 8));
  all.add("a triangle nearer than the near plane", upright(0.4625, -0.1, 0.1, 0, 0.75));
  all.add(
      "a triangle far in front of the near plane",
      {StereoPoint{0.5f, 0.25f, 0, -3, 1}, {0.75f, 0.5f, 0, -4, 1}, {0.5f, 0.25f, 0.5f, -3, 1}});
  all.add("behind the eyes", upright(0.9, -1, 1, 0, -8));
  all.add("a triangle beyond the far plane", upright(-3, -1, 1, 0, 70));
  all.add("a triangle across the left side of the frustum", upright(0.1, -10, -6, 0, 8));
  CullCase behind{"triangles at the sides, behind the window (C-74)", {}, {}};
  behind.add("a triangle that only the left eye sees, at its right side",
             upright(-1.5, 40.25, 41.25, 0, 40));
  behind.add("a triangle that only the right eye sees, at its left side",
             upright(-1.5, -41.25, -40.25, 3, 40));
  behind.add("seen by both", upright(-1.5, 37, 38, -5, 40));
  behind.add("a triangle too far to the right for both eyes", upright(-1.5, 42, 43, 0, 40));
  behind.add("a triangle too far to the left for both eyes", upright(-1.5, -43, -42, 0, 40));
  CullCase before{"triangles at the sides, in front of the window (C-73)", {}, {}};
  before.add("a triangle that only the right eye sees", upright(0.4, 1.75, 2.25, 0, 2));
  before.add("a triangle that only the left eye sees", upright(0.4, -2.25, -1.75, 0, 2));
  before.add("seen by both", upright(0.4, 0.5, 1, 0, 2));
  before.add("a triangle too far to the right for both eyes", upright(0.4, 2.5, 3, 0, 2));
  before.add("a triangle too far to the left for both eyes", upright(0.4, -3, -2.5, 0, 2));
  return {all, behind, before};
}
// BEGIN HIDDEN
inline std::vector<CullCase> hidden_triangles() {
  CullCase odd{"triangles whose corners are outside different planes", {}, {}};
  odd.add("a triangle between the frusta of eyes that are far apart",
          upright(2.55, -0.25, 0.25, 0, 1.5));
  odd.add("a triangle that only the right eye sees", upright(2.55, 1.5, 2, 0, 1.5));
  odd.add("a triangle around the whole view, with each corner outside another plane",
          {seen_at(0.1, -50, -20, 8), seen_at(0.1, 50, -20, 8), seen_at(0.1, 0, 60, 8)});
  odd.add("a triangle with a corner on the right side of the left eye's frustum",
          {StereoPoint{8, 6, 0, 4, 8}, {9, 9, 0, 4, 8}, {9, 9, 1, 4, 8}});
  odd.add("a triangle far in front of the near plane",
          {StereoPoint{1, 0, 0, -9, 2}, {1, 0, 1, -9, 2}, {0, -1, 0, -8, 2}});
  // Each of these triangles has one corner on a plane and the others outside it. A corner on the
  // plane is inside, so the triangle is drawn.
  odd.add("a triangle with a corner on the far plane",
          {StereoPoint{0, 0, 0, 8, 8}, {1, 1, 0, 9, 8}, {0, 0, 1, 9, 8}});
  odd.add("a triangle with a corner on the top plane",
          {StereoPoint{0, 0, 8, 4, 8}, {1, 1, 9, 4, 8}, {-1, -1, 9, 4, 8}});
  odd.add("a triangle with a corner on the bottom plane",
          {StereoPoint{0, 0, -8, 4, 8}, {1, 1, -9, 4, 8}, {-1, -1, -9, 4, 8}});
  odd.add(
      "a triangle with a corner on the left side of the left eye's frustum, outside the right "
      "eye's",
      {StereoPoint{-8, -10, 0, 4, 8}, {-9, -11, 0, 4, 8}, {-9, -11, 1, 4, 8}});
  odd.add(
      "a triangle with a corner on the right side of the left eye's frustum, outside the right "
      "eye's",
      {StereoPoint{8, 10, 0, 4, 8}, {9, 11, 0, 4, 8}, {9, 11, 1, 4, 8}});
  odd.add(
      "a triangle with a corner on the left side of the right eye's frustum, outside the left "
      "eye's",
      {StereoPoint{-10, -8, 0, 4, 8}, {-11, -9, 0, 4, 8}, {-11, -9, 1, 4, 8}});
  odd.add(
      "a triangle with a corner on the right side of the right eye's frustum, outside the left "
      "eye's",
      {StereoPoint{10, 8, 0, 4, 8}, {11, 9, 0, 4, 8}, {11, 9, 1, 4, 8}});
  odd.add("a triangle beyond the far plane, with one corner behind the eyes",
          {StereoPoint{0, 0, 0, 1, -1}, {0, 0, 0, 10, 8}, {1, 1, 0, 10, 8}});
  odd.add("a triangle on the near plane",
          {StereoPoint{0, 0, 0, 0, 1}, {1, 1, 0, 0, 1}, {0, 0, 1, 0, 1}});
  odd.add("a triangle with two corners above the view and one far below it",
          {seen_at(0.1, 0, 20, 8), seen_at(0.1, 1, 20, 8), seen_at(0.1, 0, -20, 8)});
  glassbox::Random random(9);
  CullCase many{"two hundred triangles", {}, {}};
  for (int i = 0; i < 200; ++i) {
    const double half = random.between(0.05, 1), window = random.between(2, 20);
    const double distance = random.between(-2, 40), x = random.between(-1.5, 1.5) * distance;
    const double y = random.between(-1.2, 1.2) * distance;
    std::array<StereoPoint, 3> triangle;
    for (StereoPoint& each : triangle) {
      const double right = x + random.between(-1, 1), up = y + random.between(-1, 1);
      const double at = distance + random.between(-1, 1);
      each = seen_at(half * (1 - at / window), right, up, at);
    }
    many.add("random", triangle);
  }
  return {odd, many};
}
// END HIDDEN

// ---- anaglyphs (task 9.4) ----

enum class Lenses { kRedCyan, kGreenMagenta, kAmberBlue };

struct AnaglyphCase {
  const char* what;
  Anaglyph anaglyph;
};

inline AnaglyphCase anaglyph_case(const char* what, Lenses lenses, int width, int height) {
  AnaglyphCase c{what, {}};
  c.anaglyph.width = width;
  c.anaglyph.height = height;
  if (lenses == Lenses::kGreenMagenta) {
    c.anaglyph.left_mask = {false, true, false};
    c.anaglyph.right_mask = {true, false, true};
  }
  if (lenses == Lenses::kAmberBlue) {
    c.anaglyph.left_mask = {true, true, false};
    c.anaglyph.right_mask = {false, false, true};
  }
  return c;
}

inline std::vector<AnaglyphCase> anaglyphs() {
  const Rgba8 cream{250, 240, 200, 255}, slate{60, 70, 90, 255}, leaf{30, 160, 50, 255};
  AnaglyphCase apart =
      anaglyph_case("one pixel, with one fragment for each eye", Lenses::kRedCyan, 5, 3);
  apart.anaglyph.background = slate;
  apart.anaglyph.left = {{3, 1, 0.5f, cream}};
  apart.anaglyph.right = {{1, 1, 0.5f, cream}};
  AnaglyphCase order =
      anaglyph_case("in one pixel the near fragment comes first, in the other the far one",
                    Lenses::kRedCyan, 4, 2);
  order.anaglyph.left = {{0, 0, 0.25f, cream}, {0, 0, 0.75f, leaf}, {1, 1, 0.75f, leaf}};
  order.anaglyph.right = {{2, 0, 0.75f, leaf}, {2, 0, 0.25f, cream}, {1, 1, 0.75f, cream}};
  AnaglyphCase hidden = anaglyph_case(
      "a pixel with a near fragment for the left eye and a far one for the right eye (C-76)",
      Lenses::kRedCyan, 4, 2);
  hidden.anaglyph.background = {0, 0, 40, 255};
  hidden.anaglyph.left = {{1, 0, 0.25f, cream}, {2, 0, 0.75f, leaf}};
  hidden.anaglyph.right = {{0, 0, 0.25f, cream}, {1, 0, 0.75f, leaf}, {2, 0, 0.75f, leaf}};
  AnaglyphCase green = anaglyph_case("a green and a magenta lens", Lenses::kGreenMagenta, 3, 2);
  green.anaglyph.background = slate;
  green.anaglyph.left = {{0, 0, 0.5f, cream}, {1, 1, 0.5f, leaf}};
  green.anaglyph.right = {{1, 1, 0.5f, cream}, {2, 1, 0.5f, leaf}};
  return {apart, order, hidden, green};
}
// BEGIN HIDDEN
inline std::vector<AnaglyphCase> hidden_anaglyphs() {
  AnaglyphCase equal =
      anaglyph_case("equally near fragments, of which the first stays", Lenses::kRedCyan, 3, 2);
  equal.anaglyph.left = {{1, 0, 0.5f, {10, 20, 30, 255}}, {1, 0, 0.5f, {40, 50, 60, 255}}};
  equal.anaglyph.right = {{1, 0, 0.5f, {70, 80, 90, 255}}, {1, 0, 0.5f, {1, 2, 3, 255}}};
  AnaglyphCase far = anaglyph_case("fragments on the far plane, over a bright background",
                                   Lenses::kAmberBlue, 3, 2);
  far.anaglyph.background = {255, 255, 255, 255};
  far.anaglyph.left = {{0, 1, 1.0f, {9, 8, 7, 255}}};
  far.anaglyph.right = {{2, 1, 1.0f, {4, 5, 6, 255}}};
  std::vector<AnaglyphCase> all{equal, far};
  glassbox::Random random(94);
  const auto byte = [&] { return std::uint8_t(random.integer(0, 255)); };
  for (const Lenses lenses : {Lenses::kRedCyan, Lenses::kGreenMagenta, Lenses::kAmberBlue}) {
    AnaglyphCase c = anaglyph_case("many fragments", lenses, 12, 7);
    c.anaglyph.background = {byte(), byte(), byte(), 255};
    for (auto* fragments : {&c.anaglyph.left, &c.anaglyph.right}) {
      for (int i = 0; i < 150; ++i) {
        const int x = int(random.integer(0, 11)), y = int(random.integer(0, 6));
        const float depth = float(random.integer(0, 16)) / 16;
        fragments->push_back({x, y, depth, {byte(), byte(), byte(), 255}});
      }
    }
    all.push_back(c);
  }
  return all;
}
// END HIDDEN

// ---- colours (task 9.5) ----

struct ColourCase {
  const char* what;
  Matrix matrix;
  Recolour recolour;
  Colour left, right;
};

inline Matrix mask_matrix() {
  return {{{1, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 1, 0}, {0, 0, 0, 0, 0, 1}}};
}
// The matrix of Dubois (2009).
inline Matrix dubois_matrix() {
  return {{{0.437, 0.449, 0.164, -0.011, -0.032, -0.007},
           {-0.062, -0.062, -0.024, 0.377, 0.761, 0.009},
           {-0.048, -0.050, -0.017, -0.026, -0.093, 1.234}}};
}
inline std::vector<ColourCase> colours() {
  return {{"by masks", mask_matrix(), {0, 0}, {0.9, 0.2, 0.1}, {0.5, 0.4, 0.3}},
          {"half desaturated", mask_matrix(), {0.5, 0}, {1, 0, 0}, {1, 0, 0}},
          {"brightened too", mask_matrix(), {0.7, 0.2}, {0.1, 0.8, 0.3}, {0.2, 0.7, 0.4}},
          {"red by Dubois' matrix, whose other rows are negative there (C-77)",
           dubois_matrix(),
           {0, 0},
           {1, 0, 0},
           {0, 0, 0}},
          {"a dull colour by Dubois' matrix",
           dubois_matrix(),
           {0, 0},
           {0.4, 0.3, 0.5},
           {0.3, 0.3, 0.6}}};
}
// BEGIN HIDDEN
inline std::vector<ColourCase> hidden_colours() {
  return {{"blue by Dubois' matrix, where the result is above 1",
           dubois_matrix(),
           {0, 0},
           {0, 0, 0},
           {0, 0, 1}},
          {"white", dubois_matrix(), {0.3, 0.4}, {1, 1, 1}, {1, 1, 1}},
          {"grey", mask_matrix(), {1, 0}, {0.2, 0.9, 0.4}, {0.8, 0.1, 0.3}},
          {"yellow for one eye, blue for the other",
           dubois_matrix(),
           {0.85, 0.1},
           {1, 1, 0},
           {0, 0, 1}}};
}
// END HIDDEN

// ---- sequences of frames (task 9.6) ----

struct ComfortCase {
  const char* what;
  Picture picture;
  Budget budget;
  std::vector<Frame> frames;
  double release_frames;
};

inline std::vector<Frame> repeated(const Frame& first, int a, const Frame& second, int b) {
  std::vector<Frame> frames(std::size_t(a), first);
  frames.insert(frames.end(), std::size_t(b), second);
  return frames;
}

inline std::vector<ComfortCase> sequences() {
  const Picture picture{1.5, 1280};
  const Budget budget{30, 20};
  return {
      {"frames that do not depend on each other (release in 0 frames)",
       picture,
       budget,
       {{2, 20, 5}, {3, kInfinity, 4}, {5, 9, 5}, {1, 6, 6}, {4, 4.5, 6}, {5, 5, 5}},
       0},
      {"an object that suddenly comes near", picture, budget,
       repeated({3, 20, 5}, 3, {1, 20, 5}, 3), 15},
      {"an object that suddenly goes away, after which the eyes move apart slowly", picture, budget,
       repeated({1, 20, 5}, 3, {3, 20, 5}, 8), 15},
  };
}
// BEGIN HIDDEN
inline std::vector<ComfortCase> hidden_sequences() {
  const Picture picture{1.9, 1920};
  glassbox::Random random(96);
  std::vector<Frame> walk;
  for (int i = 0; i < 60; ++i) {
    const double nearest = random.between(0.5, 6), farthest = nearest + random.between(0, 30);
    walk.push_back({nearest, farthest, random.between(1, 12)});
  }
  return {
      {"a window that jumps from 10 to 1 and back (C-79)",
       picture,
       {58, 58},
       [] {
         auto frames = repeated({0.9, 40, 10}, 4, {0.9, 40, 1}, 8);
         frames.insert(frames.end(), 12, Frame{0.9, 40, 10});
         return frames;
       }(),
       8},
      {"65 mm behind a screen 2 m wide (C-72)",
       picture,
       {80, 62.4},
       {{8, 20, 10}, {8, 100, 10}, {8, kInfinity, 10}, {0.4, kInfinity, 0.5}, {24, 60, 30}},
       0},
      {"a budget of 0 in front of the window",
       picture,
       {0, 40},
       repeated({2, 9, 2}, 2, {1.5, 9, 2}, 4),
       3},
      {"eyes without skew",
       picture,
       {30, 20},
       repeated({2, 50, kInfinity}, 3, {4, 50, kInfinity}, 3),
       2},
      {"sixty frames with random distances", picture, {40, 25}, walk, 15},
  };
}
// END HIDDEN

}  // namespace inputs
}  // namespace lab_09
