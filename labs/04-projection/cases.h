// The inputs of lab 4's cases: the runner passes them to the student's functions, the judge to the
// pipeline's.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include <glassbox/base/random.h>

#include "labs/framework/varied_inputs.h"
#include "student.h"

namespace lab_04 {
// A namespace of its own: a function or type of yours in student.cpp may have the name of one of
// these, and does not replace it.
inline namespace inputs {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

struct Camera {
  double fovy_radians, aspect, near, far;
};

inline std::vector<Camera> cameras() {
  return {{1.0, 4.0 / 3, 0.1, 100},
          {0.5, 16.0 / 9, 1, 10},
          {1.5707963267948966, 1, 1, 2},
          {1.2, 0.5, 0.5, 64}};
}

// The first camera of each case is valid, so a function that refuses everything does not pass.
inline std::vector<std::vector<Camera>> refusals() {
  return {{{1, 1, 1, 2},
           {0, 1, 1, 2},
           {-1, 1, 1, 2},
           {3.1415, 1, 1, 2},
           {3.1415927, 1, 1, 2},
           {3.2, 1, 1, 2}},
          {{1, 1, 1, 2}, {1, 0, 1, 2}, {1, -1, 1, 2}, {1, kInfinity, 1, 2}},
          {{1, 1, 1, kInfinity}, {1, 1, 0, 2}, {1, 1, -1, 2}, {1, 1, 2, 2}, {1, 1, 3, 2}},
          {{1, 1, 1, 2}, {kNaN, 1, 1, 2}, {1, kNaN, 1, 2}, {1, 1, kNaN, 2}, {1, 1, 1, kNaN}}};
}

struct Box {
  double left, right, bottom, top, near, far;
};

inline std::vector<Box> boxes() {
  return {
      {-1, 1, -1, 1, 0, 1}, {-4, 4, -3, 3, 0.5, 20}, {0, 640, 0, 480, 1, 2}, {-1, 3, -2, 1, -5, 5}};
}

// BEGIN HIDDEN
// Planes far apart, an infinite far plane, narrow and wide views (C-08, C-10).
inline std::vector<Camera> stiff_cameras() {
  return glassbox::labs::with_varied(
      std::vector<Camera>{
          {1, 1.5, 0.1, kInfinity}, {1, 1.5, 1e-6, 1e6}, {1e-6, 1, 1, 2}, {3.1, 1, 1, 1000}},
      41, 3, [](glassbox::Random& random) {
        const double fovy = random.between(0.3, 2.5), aspect = random.between(0.5, 2.5);
        const double near = random.between(0.01, 2);
        return Camera{fovy, aspect, near, near + random.between(1, 1000)};
      });
}
inline std::vector<Box> more_boxes() {
  return glassbox::labs::with_varied(
      std::vector<Box>{{-1e6, 1e-3, 5, 6, 1, 1e9}, {7, 9, -11, -10, -100, -1}}, 42, 3,
      [](glassbox::Random& random) {
        const double left = random.between(-9, 9), bottom = random.between(-9, 9);
        const double near = random.between(-9, 9), width = random.between(1, 9);
        const double height = random.between(1, 9);
        return Box{left, left + width, bottom, bottom + height, near, near + random.between(1, 99)};
      });
}
// END HIDDEN

struct DialectCase {
  const char* what;
  Dialect dialect;
  Projection m;
};

// A projection whose numbers have few bits, with no 0 where another number is possible, so that an
// entry in a wrong place is noticed.
inline Projection off_centre() {
  Projection m;
  m.at(0, 0) = 1.5;
  m.at(0, 2) = 0.25;
  m.at(1, 1) = 2;
  m.at(1, 2) = -0.5;
  m.at(2, 2) = -1.25;
  m.at(2, 3) = -0.625;
  m.at(3, 2) = -1;
  m.at(3, 3) = 0;
  return m;
}
inline Projection parallel() {
  Projection m;
  m.at(0, 0) = 0.5;
  m.at(0, 3) = -0.25;
  m.at(1, 1) = 0.75;
  m.at(1, 3) = 0.125;
  m.at(2, 2) = -0.375;
  m.at(2, 3) = -0.5;
  return m;
}

// A projection with thirds as entries. One third has infinitely many binary digits, of which float
// keeps fewer than double, so computing in float is noticed.
inline Projection of_thirds() {
  Projection m = off_centre();
  for (int i = 0; i < 16; ++i) m.at(i / 4, i % 4) /= 3;
  return m;
}

inline std::vector<DialectCase> in_clip_space(Dialect dialect) {
  return {
      {"perspective, off centre", dialect, off_centre()},
      {"parallel", dialect, parallel()},
      {"a perspective matrix, all of whose entries are divided by three", dialect, of_thirds()}};
}

inline std::vector<Point<Clip, double>> points() {
  return {{1, 2, 3, 4}, {-0.3, 0.7, 0.1, 1},       {5, -5, 0.2, 0.3}, {1, 2, 3, -4},
          {1, 1, 1, 0}, {-1e-3, 2e-3, 5e-4, 7e-3}, {1, 2, 3, kNaN}};
}

struct ViewportCase {
  Point<Ndc, double> p;
  Rectangle viewport;
};

inline std::vector<ViewportCase> on_the_picture() {
  constexpr Rectangle kPicture{0, 0, 640, 480};
  return {{{-1, 1, 0}, kPicture},
          {{1, -1, 1}, kPicture},
          {{0, 0.5, 0.25}, kPicture},
          {{0.3, -0.7, 0.9}, kPicture},
          {{-0.123, 0.25, 0.5}, kPicture}};
}

struct DepthCase {
  double depth, near, far;
};

inline std::vector<DepthCase> depths() {
  return {{0, 0.5, 64},     {1, 0.5, 64},       {0.5, 1, 3},
          {0.75, 0.1, 100}, {0.999, 0.1, 1000}, {0.5, 0.25, kInfinity}};
}

// BEGIN HIDDEN
inline std::vector<ViewportCase> viewports() {
  return glassbox::labs::with_varied(
      std::vector<ViewportCase>{{{-1, 1, 0.5}, {100, 50, 320, 200}},
                                {{0.5, 0.75, 0.5}, {-16, 32, 64, 48}},
                                {{1.5, -2, 1.25}, {3, 5, 7, 11}},
                                {{0.1, 0.2, 0.3}, {0, 0, 32768, 16384}}},
      43, 3, [](glassbox::Random& random) {
        const auto whole = [&](int low, int high) { return double(random.integer(low, high)); };
        const double x = random.between(-1, 1), y = random.between(-1, 1), z = random.between(0, 1);
        const double left = whole(-99, 99), top = whole(-99, 99), width = whole(1, 999);
        return ViewportCase{{x, y, z}, {left, top, width, whole(1, 999)}};
      });
}
inline std::vector<DepthCase> stiff_depths() {
  return glassbox::labs::with_varied(
      std::vector<DepthCase>{{1 - 0x1p-24, 0.1, 1e4},
                             {1 - 0x1p-40, 0.1, kInfinity},
                             {1, 0.1, kInfinity},
                             {1e-9, 1, 1e9}},
      45, 3, [](glassbox::Random& random) {
        const double depth = random.unit(), near = random.between(0.01, 2);
        return DepthCase{depth, near, near + random.between(1, 1000)};
      });
}
inline std::vector<Point<Clip, double>> random_points() {
  glassbox::Random random = glassbox::labs::varied(44);
  std::vector<Point<Clip, double>> all{{3e-308, -1e-308, 5e-309, 1e-308}};
  for (int i = 0; i < 6; ++i) {
    const double x = random.between(-3, 3), y = random.between(-3, 3), z = random.between(-1, 2);
    all.push_back({x, y, z, random.between(-1, 4)});
  }
  return all;
}
// END HIDDEN

}  // namespace inputs
}  // namespace lab_04
