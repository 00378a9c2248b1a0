// The inputs of lab 3's test cases: for the runner, which calls the student's functions, and for
// the checks, which compute the expected answers.
#pragma once

#include <limits>
#include <vector>

#include "labs/framework/varied_inputs.h"
#include "student.h"

namespace lab_03 {
// A namespace of its own: a function or type of yours in student.cpp may have the name of one of
// these, and does not replace it.
inline namespace inputs {

// ---- cameras (tasks 3.1 and 3.3) ----

struct CameraCase {
  const char* what;
  Camera camera;
};

inline std::vector<CameraCase> cameras() {
  return {
      {"at the origin, along -z", {{0, 0, 0}, {0, 0, -1}, {0, 1, 0}}},
      {"beside the scene, with a horizontal gaze", {{4, 0, 3}, {0, 0, 0}, {0, 1, 0}}},
      {"from above, `up` not perpendicular to the gaze", {{2, 5, 6}, {0, 1, -1}, {0, 1, 0}}},
      {"rolled about the gaze, with an `up` longer than 1",
       {{-3, 2, 1}, {4, -1, -5}, {10, 20, -4}}},
      {"from behind the scene, along +z and down", {{1, 3, -8}, {1, 1, 2}, {0, 1, 0}}},
  };
}
// BEGIN HIDDEN
inline std::vector<CameraCase> hidden_cameras() {
  return glassbox::labs::with_varied(
      std::vector<CameraCase>{
          {"far away (C-13)", {{1e6, -2e6, 5e5}, {1e6 + 3, -2e6 + 1, 5e5 - 7}, {0, 1, 0}}},
          {"`up` a thousandth of a radian from the gaze (C-01)",
           {{0, 0, 0}, {0, 1000, -1}, {0, 1, 0}}},
          {"z is up", {{5, -4, 3}, {0, 0, 1}, {0, 0, 1}}},
          {"upside down", {{1, 2, 3}, {-2, 0, -4}, {0, -1, 0}}},
          {"vectors of very different lengths", {{0, 0, 0}, {3e60, 0, -4e60}, {1e-71, 2e-70, 0}}},
          {"very small coordinates", {{1e-6, 2e-6, 3e-6}, {0, 0, 0}, {1, 0, 0}}},
          {"exactly along +z (C-05)", {{2, -1, -4}, {2, -1, 6}, {1, 2, 0}}},
          {"almost along +z (C-05)", {{0, 0, 0}, {0.000001, 0, 1}, {0, 1, 0}}},
      },
      31, 3, [](glassbox::Random& random) {
        for (;;) {
          double v[9];
          for (double& each : v) each = random.between(-10, 10);
          const Camera camera{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}};
          const auto gaze = camera.target - camera.eye, across = cross(camera.up, gaze);
          // Accepts a camera only if its gaze is longer than 1, and `up` is at least a tenth of a
          // radian away from the gaze and from its opposite.
          if (dot(across, across) > 0.01 * dot(gaze, gaze) * dot(camera.up, camera.up) &&
              dot(gaze, gaze) > 1)
            return CameraCase{"anywhere", camera};
        }
      });
}
// END HIDDEN

// A camera that has no view matrix, and a similar one that has.
struct RefusedCase {
  const char* what;
  Camera bad, good;
};
inline std::vector<RefusedCase> refused_cameras() {
  return {
      {"the target is the eye (C-02)",
       {{1, 2, 3}, {1, 2, 3}, {0, 1, 0}},
       {{1, 2, 3}, {1, 2, 2}, {0, 1, 0}}},
      {"`up` along the gaze (C-01)",
       {{0, 5, 0}, {0, 0, 0}, {0, 1, 0}},
       {{0, 5, 0}, {0, 0, 0}, {0, 0, -1}}},
      {"`up` is zero (C-03)",
       {{0, 0, 0}, {1, 1, 1}, {0, 0, 0}},
       {{0, 0, 0}, {1, 1, 1}, {0, 1e-9, 0}}},
  };
}
// BEGIN HIDDEN
inline std::vector<RefusedCase> hidden_refused_cameras() {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  return {
      {"`up` 10^-7 of a radian from the gaze (C-01)",
       {{0, 0, 0}, {0, 10000000, -1}, {0, 1, 0}},
       {{0, 0, 0}, {0, 100000, -1}, {0, 1, 0}}},
      {"an `up` that is NaN (C-03)",
       {{0, 0, 0}, {1, 1, 1}, {0, kNan, 0}},
       {{0, 0, 0}, {1, 1, 1}, {0, 3, 0}}},
      {"a target that is infinite (C-03)",
       {{0, 0, 0}, {1, 1, -kInfinity}, {0, 1, 0}},
       {{0, 0, 0}, {1, 1, -1e50}, {0, 1, 0}}},
      {"an eye that is infinite (C-03)",
       {{kInfinity, 0, 0}, {1, 1, 1}, {0, 1, 0}},
       {{1e9, 0, 0}, {1, 1, 1}, {0, 1, 0}}},
  };
}
// END HIDDEN

// ---- directions (task 3.2) ----

struct OntoCase {
  const char* what;
  Vector<World, double> from, to;
};

inline std::vector<OntoCase> directions() {
  return {
      {"x to y", {1, 0, 0}, {0, 1, 0}},
      {"an acute angle", {1, 2, 2}, {2, 3, 6}},
      {"an obtuse one", {4, 0, -3}, {-5, 12, 1}},
      {"directions a ten-thousandth of a radian apart (C-04)", {1, 2, 2}, {10002, 19999, 20000}},
  };
}
inline std::vector<OntoCase> opposite_directions() {
  return {
      {"z to -z (C-05)", {0, 0, 1}, {0, 0, -1}},
      {"a slanted direction turned round (C-05)", {1, -2, 2}, {-1, 2, -2}},
  };
}
// BEGIN HIDDEN
inline std::vector<OntoCase> hidden_directions() {
  return glassbox::labs::with_varied(
      std::vector<OntoCase>{
          {"a direction onto itself", {3, -4, 12}, {3, -4, 12}},
          {"a millionth of a radian (C-04)", {0, 0, 5}, {0.000003, 0.000004, 5}},
          {"almost opposite (C-05)", {0, 0, 1}, {0.000001, 0, -1}},
          {"almost opposite, and slanted (C-05)", {1, 2, 2}, {-1.000001, -2, -2}},
          {"vectors of very different lengths", {1e-30, 2e-30, 0}, {0, 1e30, 1e30}},
      },
      32, 3, [](glassbox::Random& random) {
        for (;;) {
          double v[6];
          for (double& each : v) each = double(random.integer(-9, 9));
          const Vector<World, double> from{v[0], v[1], v[2]}, to{v[3], v[4], v[5]};
          const auto across = cross(from, to);
          if (dot(across, across) > 0) return OntoCase{"whole numbers", from, to};
        }
      });
}
inline std::vector<OntoCase> hidden_opposite_directions() {
  return {
      {"x to -x", {3, 0, 0}, {-1, 0, 0}},
      {"-y to y", {0, -1, 0}, {0, 7, 0}},
      {"-x to x", {-2, 0, 0}, {5, 0, 0}},
      {"-z to z", {0, 0, -3}, {0, 0, 1}},
      {"opposite directions, all components different", {2, 3, -6}, {-2, -3, 6}},
  };
}
// END HIDDEN

// ---- matrices (task 3.4) ----

struct KindCase {
  const char* what;
  Transform<World, World> matrix;
};

inline Transform<World, World> rows(const double (&m)[3][3]) {
  Transform<World, World> matrix;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) matrix.at(i, j) = m[i][j];
  }
  return matrix;
}

inline std::vector<KindCase> kinds() {
  return {
      {"a quarter turn", rows({{0, -1, 0}, {1, 0, 0}, {0, 0, 1}})},
      {"x reversed: the mirror in slide S3.37 (C-06)", rows({{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}})},
      {"two axes reversed", rows({{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}})},
      {"a uniform scale", rows({{2, 0, 0}, {0, 2, 0}, {0, 0, 2}})},
      {"a shear, whose determinant is 1", rows({{1, 0.5, 0}, {0, 1, 0}, {0, 0, 1}})},
      {"columns of length 1 that are not perpendicular",
       rows({{1, 0.6, 0}, {0, 0.8, 0}, {0, 0, 1}})},
      {"a scale of z alone", rows({{0, -1, 0}, {1, 0, 0}, {0, 0, 2}})},
  };
}
// BEGIN HIDDEN
inline std::vector<KindCase> hidden_kinds() {
  return {
      {"a rotation with seven digits (C-12)", rows({{0.6666667, -0.3333333, 0.6666667},
                                                    {0.6666667, 0.6666667, -0.3333333},
                                                    {-0.3333333, 0.6666667, 0.6666667}})},
      {"x and y exchanged", rows({{0, 1, 0}, {1, 0, 0}, {0, 0, 1}})},
      {"a rotation by 45 degrees with one row reversed",
       rows({{0.70710678118654752, -0.70710678118654752, 0},
             {0.70710678118654752, 0.70710678118654752, 0},
             {0, 0, -1}})},
      {"a scale by a half", rows({{0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}})},
      {"columns of length 1 at an obtuse angle", rows({{1, -0.6, 0}, {0, 0.8, 0}, {0, 0, 1}})},
      {"axes stretched by a thousandth", rows({{1.001, 0, 0}, {0, 1, 0}, {0, 0, 1}})},
      {"NaN", rows({{std::numeric_limits<double>::quiet_NaN(), 0, 0}, {0, 1, 0}, {0, 0, 1}})},
  };
}
// END HIDDEN

// ---- projections of a left-handed eye (task 3.5) ----

// A projection by the distance d of the near plane, the distance f of the far plane, and half the
// height h of the window on the near plane.
struct HandCase {
  double d, f, h;
};

// The perspective projection T_pers of the slides (S4.18 to S4.20), for a left-handed eye space.
inline Transform<Clip, Eye> watt_projection(const HandCase& p) {
  Transform<Clip, Eye> m;
  m.at(0, 0) = m.at(1, 1) = p.d / p.h;
  m.at(2, 2) = p.f / (p.f - p.d);
  m.at(2, 3) = -p.d * p.f / (p.f - p.d);
  m.at(3, 2) = 1;
  m.at(3, 3) = 0;
  return m;
}

inline std::vector<HandCase> hands() {
  return {{1, 10, 0.5}, {0.1, 1000, 0.04}};
}
// BEGIN HIDDEN
inline std::vector<HandCase> hidden_hands() {
  return glassbox::labs::with_varied(
      std::vector<HandCase>{{2, 3, 5}, {0.5, 1e6, 0.25}}, 35, 2, [](glassbox::Random& random) {
        const double near = random.between(0.1, 2), far = near + random.between(1, 100);
        return HandCase{near, far, random.between(0.1, 2)};
      });
}
// END HIDDEN

}  // namespace inputs
}  // namespace lab_03
