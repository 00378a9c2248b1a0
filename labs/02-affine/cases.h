// The inputs of lab 2's test cases: for the runner, which calls the student's functions, and for
// the checks, which compute the expected answers.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "labs/framework/varied_inputs.h"
#include "student.h"

namespace lab_02 {
// A namespace of its own: a function or type of yours in student.cpp may have the name of one of
// these, and does not replace it.
inline namespace inputs {

// ---- task 2.1 ----

struct TurnCase {
  Point2 centre;
  double degrees;
};

inline std::vector<TurnCase> turns() {
  return {{{0, 0}, 30}, {{3, 1}, 90}, {{-2, 5}, 40}, {{100, -250}, -75}};
}
// BEGIN HIDDEN
inline std::vector<TurnCase> hidden_turns() {
  return glassbox::labs::with_varied(
      std::vector<TurnCase>{{{0.5, 0.25}, 180}, {{-12, 7}, 359}, {{1e6, 2e6}, 10}, {{7, -7}, -200}},
      21, 3, [](glassbox::Random& random) {
        const double x = random.between(-50, 50), y = random.between(-50, 50);
        return TurnCase{{x, y}, random.between(-180, 180)};
      });
}
// END HIDDEN

// ---- task 2.2 ----

struct ComposeCase {
  const char* what;
  std::vector<Step> steps;
};

inline Step move(double x, double y, double z) {
  return {Step::Kind::kTranslate, {x, y, z}, 0, 0, 1};
}
inline Step turn(double x, double y, double z, double degrees) {
  return {Step::Kind::kRotate, {x, y, z}, degrees, 0, 1};
}
inline Step scale(double x, double y, double z) {
  return {Step::Kind::kScale, {x, y, z}, 0, 0, 1};
}
inline Step shear(int changed, int by, double factor) {
  return {Step::Kind::kShear, {0, 0, 0}, factor, changed, by};
}

inline std::vector<ComposeCase> single_steps() {
  return {
      {"move", {move(2, -3, 5)}},
      {"turn about the y axis", {turn(0, 1, 0, 30)}},
      {"turn about a slanted axis", {turn(1, 2, -2, 50)}},
      {"scale", {scale(2, 0.5, -1)}},
      {"shear: x grows with y", {shear(0, 1, 0.75)}},
  };
}
inline std::vector<ComposeCase> compositions() {
  return {
      {"turn, then move (C-19)", {turn(0, 0, 1, 35), move(4, 1, 0)}},
      {"move, then turn (C-19)", {move(4, 1, 0), turn(0, 0, 1, 35)}},
      {"scale, then turn, then move: the usual order for a model",
       {scale(1, 2, 3), turn(1, 1, 0, 65), move(-1, 5, 2)}},
      {"a turn about a point that is not the origin",
       {move(-2, -3, -4), turn(2, -1, 1, 110), move(2, 3, 4)}},
  };
}
// BEGIN HIDDEN
inline std::vector<ComposeCase> hidden_compositions() {
  std::vector<Step> deep;  // a deep chain of steps (C-15)
  for (int i = 0; i < 12; ++i) {
    deep.push_back(turn(1, i % 3, 2 - i % 4, 20 + 13 * i));
    deep.push_back(scale(1.5, i % 2 == 0 ? 0.5 : 2, 1));
    deep.push_back(move(i, -2, 0.5));
  }
  return glassbox::labs::with_varied(
      std::vector<ComposeCase>{
          {"no step", {}},
          {"a turn, the same turn back, then a move",
           {turn(3, 4, 12, 123), turn(3, 4, 12, -123), move(1, 0, 0)}},
          {"shears between turns",
           {shear(2, 0, -1.5), turn(0, 1, 1, 77), shear(1, 2, 0.25), turn(5, 0, 1, -20)}},
          {"a reflection, and a rotation axis that is not of length 1",
           {scale(-1, 1, 1), turn(3000, -4000, 500, 210), move(1, 2, 3)}},
          {"36 steps, as in a deep hierarchy (C-15)", deep},
      },
      22, 2, [](glassbox::Random& random) {
        const auto in = [&](double low, double high) { return random.between(low, high); };
        const double x = in(-3, 3), y = in(-3, 3), size = in(0.25, 4), degrees = in(-180, 180);
        return ComposeCase{"in any order",
                           {turn(x, y, 1, degrees), scale(size, 2, -1), move(y, in(-9, 9), x),
                            shear(2, 0, in(-2, 2)), turn(1, x, y, in(-180, 180))}};
      });
}
// END HIDDEN

// ---- task 2.3 ----

struct FitCase {
  const char* what;
  std::array<Point2, 3> source, target;
};

inline std::vector<FitCase> fits() {
  return {
      {"a turn by 90 degrees", {{{0, 0}, {1, 0}, {0, 1}}}, {{{0, 0}, {0, 1}, {-1, 0}}}},
      {"a shear and a move", {{{0, 0}, {4, 0}, {0, 2}}}, {{{5, 7}, {9, 7}, {8, 9}}}},
      {"any triangle to any other", {{{1, 2}, {7, 3}, {4, 11}}}, {{{-3, 5}, {2, 2}, {9, -4}}}},
      {"a small triangle far from the origin",
       {{{500000, 700001}, {500003, 700002}, {500001, 700005}}},
       {{{1, 2}, {3, 8}, {-7, 4}}}},
  };
}
// BEGIN HIDDEN
inline std::vector<FitCase> hidden_fits() {
  return glassbox::labs::with_varied(
      std::vector<FitCase>{
          {"a needle: ill-conditioned",
           {{{0, 0}, {1000, 1}, {2001, 2}}},
           {{{1, 1}, {4, -2}, {3, 5}}}},
          {"a needle far away",
           {{{-900000, 800000}, {-899000, 800001}, {-897999, 800002}}},
           {{{10, 20}, {-30, 40}, {50, 60}}}},
          {"triangles with large coordinates",
           {{{-1000003, 523}, {1000001, -77}, {12345, 999999}}},
           {{{700001, -3}, {-999983, 77777}, {5, 1048573}}}},
          {"target points on a line: the map exists, but has no inverse",
           {{{0, 1}, {5, 2}, {3, 7}}},
           {{{1, 1}, {2, 2}, {4, 4}}}},
      },
      23, 3, [](glassbox::Random& random) {
        for (;;) {
          double v[12];
          for (double& each : v) each = double(random.integer(-1000, 1000));
          const double det = (v[2] - v[0]) * (v[5] - v[1]) - (v[4] - v[0]) * (v[3] - v[1]);
          if (det > 1e4 || det < -1e4)
            return FitCase{"whole numbers",
                           {{{v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}}},
                           {{{v[6], v[7]}, {v[8], v[9]}, {v[10], v[11]}}}};
        }
      });
}
// END HIDDEN

// Three points on a line, and the same with one of them moved off the line.
struct LineCase {
  const char* what;
  std::array<Point2, 3> on_a_line, off_it;
};
inline std::vector<LineCase> lines() {
  return {{"a slanted line", {{{0, 0}, {3, 2}, {9, 6}}}, {{{0, 0}, {3, 2}, {9, 7}}}},
          {"two points that are the same", {{{5, 5}, {5, 5}, {6, 9}}}, {{{5, 5}, {5, 6}, {6, 9}}}},
          {"far away",
           {{{1000000, 999999}, {999999, 999998}, {3, 2}}},
           {{{1000000, 999999}, {999999, 999998}, {3, 3}}}}};
}

// ---- task 2.4 ----

struct RotationCase {
  const char* what;
  std::int32_t w, x, y, z;  // at most 2^25 in size
};

// The rotation of the quaternion (w; x, y, z), whose components are integers: each entry is a
// quotient of integers that are exact in double, so it has only one rounding.
inline Transform<World, World> rotation_of(const RotationCase& q) {
  const double w = q.w, v[3] = {double(q.x), double(q.y), double(q.z)};
  const double n = w * w + v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  Transform<World, World> m;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    m.at(i, i) = (w * w + v[i] * v[i] - v[j] * v[j] - v[k] * v[k]) / n;
    m.at(i, j) = 2 * (v[i] * v[j] - w * v[k]) / n;
    m.at(j, i) = 2 * (v[i] * v[j] + w * v[k]) / n;
  }
  return m;
}

inline std::vector<RotationCase> rotations() {
  return {
      {"90 degrees about the x axis", 1, 1, 0, 0},
      {"an angle whose sine is 3/5, about z", 3, 0, 0, 1},
      {"120 degrees about a diagonal", 1, 1, 1, 1},
      {"a slanted axis", 5, 1, -2, 3},
      {"an obtuse angle", 1, -2, 1, 4},
  };
}
inline std::vector<RotationCase> stiff_rotations() {
  return {
      {"a tenth of a degree (C-04)", 3000, 1, 2, 2},
      {"six millionths of a radian (C-04)", 1000000, 1, 2, -2},
      {"almost half a turn (C-05)", 1, 300000, -200000, 600000},
      {"half a turn about a slanted axis (C-05)", 0, 2, -3, 6},
  };
}
// BEGIN HIDDEN
inline std::vector<RotationCase> hidden_rotations() {
  return glassbox::labs::with_varied(
      std::vector<RotationCase>{
          {"a turn by 0 degrees", 1, 0, 0, 0},
          {"half a turn about y", 0, 0, 1, 0},
          {"half a turn about an axis whose first component is negative", 0, -1, 4, 8},
          {"almost half a turn about -z", 1, 0, 0, -10000},
          {"a thousandth of a radian", 2000, 0, 0, 1},
          {"a little less than a right angle", 100, 60, 60, -50},
      },
      24, 3, [](glassbox::Random& random) {
        const auto in = [&](int low) { return std::int32_t(random.integer(low, 9)); };
        return RotationCase{"whole numbers", in(1), in(-9), in(-9), in(1)};
      });
}
// END HIDDEN

// ---- task 2.5 ----

struct DriftCase {
  const char* what;
  Transform<World, World> matrix;
};

// The rotation after `steps` multiplications by a small rotation in float, as for a spinning
// object; rounding errors have made it drift away from a rotation (C-11).
inline Transform<World, World> drifted(int steps) {
  const auto step = round_to_float(rotation_of({"", 600, 4, -2, 1}));
  auto m = step;
  for (int i = 1; i < steps; ++i) m = step * m;
  return Transform<World, World>(glm::dmat4(m.columns));
}

// The rotation with each entry changed by up to `size`, alternately increased and decreased.
inline Transform<World, World> disturbed(const RotationCase& q, double size) {
  Transform<World, World> m = rotation_of(q);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) m.at(i, j) += size * ((i + 2 * j) % 3 - 1);
  }
  return m;
}

inline std::vector<DriftCase> drifts() {
  return {{"10^4 products in float (C-11)", drifted(10000)},
          {"a rotation written with three digits (C-12)", disturbed({"", 5, 1, -2, 3}, 0.0005)}};
}
// BEGIN HIDDEN
inline std::vector<DriftCase> hidden_drifts() {
  return glassbox::labs::with_varied(
      std::vector<DriftCase>{
          {"10^5 products in float", drifted(100000)},
          {"a rotation written with six digits", disturbed({"", 1, 7, -2, 3}, 5e-7)},
          {"an error as large as is allowed", disturbed({"", 2, -3, 1, 1}, 0.0025)}},
      25, 2, [](glassbox::Random& random) {
        const auto in = [&](int low) { return std::int32_t(random.integer(low, 9)); };
        const RotationCase q{"", in(1), in(-9), in(-9), in(1)};
        return DriftCase{"disturbed", disturbed(q, random.between(1e-6, 2e-3))};
      });
}
// END HIDDEN

}  // namespace inputs
}  // namespace lab_02
