// The inputs of lab 11's test cases: for the runner, which calls the student's functions, and for
// the checks, which compute the expected answers.
#pragma once

#include <string>
#include <vector>

#include <glassbox/base/random.h>

#include "labs/framework/varied_inputs.h"
#include "student.h"

namespace lab_11 {
// A namespace of its own: a function or type of yours in student.cpp may have the name of one of
// these, and does not replace it.
inline namespace inputs {

inline Picture noise(int width, int height, std::uint64_t seed) {
  glassbox::Random random(seed);
  Picture picture{width, height, {}};
  for (int i = 0; i < width * height; ++i) picture.grey.push_back(int(random.integer(0, 255)));
  return picture;
}

// The right camera's picture of a wall, all pixels of which have disparity d. The pixels at the
// edge that only the right camera sees are noise.
inline Picture seen_from_right(const Picture& left, int d, std::uint64_t seed) {
  Picture right = noise(left.width, left.height, seed);
  for (int y = 0; y < left.height; ++y) {
    for (int x = d; x < left.width; ++x)
      right.grey[std::size_t(y * left.width + x - d)] = left.at(x, y);
  }
  return right;
}

// Changes the contrast and the brightness: grey becomes gain (grey - 128) + 128 + offset, in
// integers. `gain` is in hundredths.
inline Picture brighter(Picture picture, int gain, int offset) {
  for (int& grey : picture.grey)
    grey = std::clamp((grey - 128) * gain / 100 + 128 + offset, 0, 255);
  return picture;
}

// ---- squares (task 11.1) ----

struct Place {
  int x = 0, y = 0, d = 0;
};
struct SadCase {
  std::string what;
  Picture left, right;
  int radius = 1;
  std::vector<Place> places;
};
inline std::vector<SadCase> squares() {
  const Picture left = noise(12, 7, 1), right = seen_from_right(left, 3, 2);
  return {{"single pixels", left, right, 0, {{5, 3, 3}, {5, 3, 2}, {8, 1, 0}}},
          {"squares of 3 x 3", left, right, 1, {{6, 3, 3}, {6, 3, 4}, {7, 2, 1}}},
          {"matches outside of the right picture", left, right, 1, {{2, 3, 3}, {2, 3, 2}}}};
}
// BEGIN HIDDEN
inline std::vector<SadCase> hidden_squares() {
  const Picture left = noise(15, 11, 3), right = noise(15, 11, 4);
  const Picture white{3, 3, std::vector<int>(9, 255)}, black{3, 3, std::vector<int>(9, 0)};
  SadCase many{"at many places", left, right, 2, {}};
  glassbox::Random random = glassbox::labs::varied(111);
  for (int i = 0; i < 60; ++i) {
    const int x = int(random.integer(0, 14)), y = int(random.integer(0, 10));
    many.places.push_back({x, y, int(random.integer(0, 9))});
  }
  return {{"squares at the edges of the picture, beyond which the last row and column are repeated",
           left,
           right,
           2,
           {{0, 0, 0}, {14, 10, 4}, {14, 0, 13}, {3, 10, 3}, {1, 5, 1}}},
          {"squares larger than the picture, with the largest possible difference",
           white,
           black,
           7,
           {{1, 1, 0}}},
          many};
}
// END HIDDEN

// ---- census (task 11.2) ----

struct CensusCase {
  std::string what;
  Picture picture;
  std::vector<Place> places;  // the disparity d of the places is not used
};
inline std::vector<CensusCase> words() {
  Picture one{5, 5, std::vector<int>(25, 100)};
  one.grey[0] = 99;  // a darker pixel, at the top left
  Picture last{5, 5, std::vector<int>(25, 100)};
  last.grey[24] = 99;
  const Picture picture = noise(9, 8, 5);
  return {{"a square with one darker pixel at the top left", one, {{2, 2}}},
          {"a square with one darker pixel at the bottom right", last, {{2, 2}}},
          {"noise", picture, {{2, 2}, {4, 4}, {6, 5}}},
          {"two pictures of the same noise, the second brighter and with more contrast",
           brighter(picture, 140, 20),
           {{2, 2}, {4, 4}, {6, 5}}}};
}
// BEGIN HIDDEN
inline std::vector<CensusCase> hidden_words() {
  CensusCase all{"everywhere", noise(8, 7, glassbox::labs::varied_seed(112)), {}};
  for (int y = 0; y < 7; ++y) {
    for (int x = 0; x < 8; ++x) all.places.push_back({x, y, 0});
  }
  const Picture flat{6, 6, std::vector<int>(36, 7)};
  return {all, {"a blank wall", flat, {{0, 0}, {3, 3}}}};
}
// END HIDDEN

struct HammingCase {
  std::string what;
  std::uint32_t a = 0, b = 0;
};
inline std::vector<HammingCase> pairs_of_words() {
  return {{"equal", 0x5a5a5a, 0x5a5a5a}, {"one bit", 0x5a5a5a, 0x5a5a5b}, {"all 24", 0xffffff, 0}};
}
// BEGIN HIDDEN
inline std::vector<HammingCase> hidden_pairs_of_words() {
  return {{"the highest bit", 0x800000, 0},
          {"some", 0x123456, 0x654321},
          {"a more than b", 0x0f0f0f, 0x0f000f}};
}
// END HIDDEN

// ---- paths (task 11.3) ----

struct PathCase {
  std::string what;
  std::vector<int> costs;
  int disparities = 1, p1 = 10, p2 = 40;
};
inline PathCase random_path(const std::string& what, int pixels, int disparities, int p1, int p2,
                            std::uint64_t seed) {
  glassbox::Random random(seed);
  PathCase made{what, {}, disparities, p1, p2};
  for (int i = 0; i < pixels * disparities; ++i) made.costs.push_back(int(random.integer(0, 100)));
  return made;
}
inline std::vector<PathCase> paths() {
  return {{"one pixel", {5, 1, 7}, 3, 10, 40},
          {"two pixels of three disparities", {0, 50, 90, 30, 30, 30}, 3, 10, 40},
          {"a penalty P2 that is the same for every jump of disparity",
           {0, 90, 90, 90, 90, 80, 80, 80, 80, 0},
           5,
           10,
           40},
          random_path("six pixels of eight disparities", 6, 8, 15, 60, 1)};
}
// BEGIN HIDDEN
inline std::vector<PathCase> hidden_paths() {
  return {random_path("a long path", 200, 16, 20, 70, glassbox::labs::varied_seed(113)),
          random_path("one disparity", 5, 1, 10, 40, 3),
          random_path("two disparities", 9, 2, 10, 40, 4),
          random_path("no penalty", 9, 6, 0, 0, 5),
          random_path("penalties P1 and P2 that are equal", 9, 6, 30, 30, 6),
          {"impossible matches", {kNever, 20, 30, kNever, kNever, 10, 15, kNever, 5}, 3, 10, 40}};
}
// END HIDDEN

// ---- winners (task 11.4) ----

struct WinnerCase {
  std::string what;
  std::vector<int> costs;
};
inline std::vector<WinnerCase> winners() {
  return {{"a lowest cost between two equal neighbours", {9, 5, 2, 5, 9}},
          {"a lowest cost between different neighbours", {90, 40, 10, 20, 80}},
          {"the first disparity has the lowest cost", {1, 5, 9}},
          {"the last disparity has the lowest cost", {9, 5, 1}},
          {"no match (C-113)", {kNever, kNever}}};
}
// BEGIN HIDDEN
inline std::vector<WinnerCase> hidden_winners() {
  return glassbox::labs::with_varied(
      std::vector<WinnerCase>{
          {"two equal costs, of which the smaller disparity wins", {9, 3, 7, 3, 8}},
          {"a blank wall", {4, 4, 4, 4}},
          {"a lowest cost beside an impossible match", {7, 3, kNever, kNever}},
          {"a lowest cost after an impossible match", {kNever, 3, 7, 9}},
          {"one disparity", {6}},
          {"costs that need more than a float", {60000, 50001, 50000, 50003}}},
      114, 3, [](glassbox::Random& random) {
        WinnerCase made{"any costs", {}};
        for (int i = 0; i < 20; ++i) made.costs.push_back(int(random.integer(0, 1000)));
        return made;
      });
}
// END HIDDEN

// ---- both pictures (task 11.5) ----

struct RowCase {
  std::string what;
  std::vector<int> costs;
  int width = 1, disparities = 1;
};
inline RowCase random_row(const std::string& what, int width, int disparities, std::uint64_t seed) {
  glassbox::Random random(seed);
  RowCase made{what, {}, width, disparities};
  for (int x = 0; x < width; ++x) {
    for (int d = 0; d < disparities; ++d)
      made.costs.push_back(d > x ? kNever : int(random.integer(0, 99)));
  }
  return made;
}
inline std::vector<RowCase> rows() {
  return {{"three pixels, two disparities", {5, kNever, 9, 1, 7, 3}, 3, 2},
          random_row("eight pixels, four disparities", 8, 4, 1)};
}
// BEGIN HIDDEN
inline std::vector<RowCase> hidden_rows() {
  return {random_row("a row", 40, 12, glassbox::labs::varied_seed(115)),
          random_row("more disparities than pixels", 5, 9, 3),
          {"equal costs, of which the smaller disparity wins", {4, kNever, 9, 4, 4, 4}, 3, 2},
          {"a right pixel that no left pixel can match", {kNever, kNever, 3, kNever}, 2, 2}};
}
// END HIDDEN

struct CheckCase {
  std::string what;
  std::vector<double> left, right;
  double tolerance = 1;
};
inline std::vector<CheckCase> pairs_of_rows() {
  return {{"all agree", {0, 1, 1, 1, 2}, {0, 1, 1, 2, kNone}, 1},
          {"pixels that are hidden from the right camera",
           {0, 0, 0, 3, 3, 0, 0},
           {3, 0, 0, 0, 0, 0, 0},
           1},
          {"a match beyond the edge of the picture, which is invalid (C-113)",
           {2, 2, 2, kNone},
           {2, 2, 2, 2},
           1},
          {"parts of a pixel", {0, 0.5, 1.25, 1.75, 2.5}, {0.5, 1, 1, 2, 2}, 0.75}};
}
// BEGIN HIDDEN
inline std::vector<CheckCase> hidden_pairs_of_rows() {
  glassbox::Random random = glassbox::labs::varied(116);
  CheckCase many{"a row", {}, {}, 1};
  for (int x = 0; x < 60; ++x) {
    many.left.push_back(double(random.integer(0, 40)) / 8);
    many.right.push_back(double(random.integer(0, 5)));
  }
  return {many,
          {"a difference of exactly the tolerance", {0, 0, 2, 2}, {1, 1, 1, 1}, 1},
          {"no tolerance", {0, 1, 1, 1}, {1, 1, 0.5, 0}, 0},
          {"halves, which are rounded to the right", {0, 0.5, 1.5, 0.5}, {9, 0.5, 1.5, 0.5}, 0},
          {"no disparities in the right picture", {0, 1, 1}, {kNone, kNone, kNone}, 1}};
}
// END HIDDEN

// ---- depths (task 11.6) ----

struct DepthCase {
  std::string what;
  double disparity = 0;
  Calibration calibration;
};
inline std::vector<DepthCase> depths() {
  const Calibration camera{800, 0.1, 0};
  // The calibration of the motorcycle scene of the Middlebury data set, in px and mm.
  const Calibration motorcycle{994.978, 193.001, 31.086};
  return {{"sixteen pixels", 16, camera},
          {"an offset of the principal points (C-114)", 40.25, motorcycle},
          {"no disparity (C-114)", kNone, motorcycle},
          {"parallel rays (C-107)", 0, camera}};
}
// BEGIN HIDDEN
inline std::vector<DepthCase> hidden_depths() {
  const Calibration crossed{500, 0.065, -8};
  return glassbox::labs::with_varied(
      std::vector<DepthCase>{{"diverging rays (C-107)", 7.5, crossed},
                             {"just in front of the cameras", 8.0009765625, crossed},
                             {"a negative disparity before an offset", -3, {800, 0.1, 5}},
                             {"rays that are parallel by the offset", 8, crossed}},
      117, 3, [](glassbox::Random& random) {
        const double d = random.between(1, 60), focal = random.between(300, 900);
        return DepthCase{"any pixel", d, {focal, random.between(0.01, 1), random.between(0, 9)}};
      });
}
// END HIDDEN

}  // namespace inputs
}  // namespace lab_11
