// The generated inputs of lab 2: of all kinds that student.h names and of the borders between them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <utility>
#include <vector>

#include "cases.h"
#include "labs/framework/bezout.h"
#include "labs/framework/choices.h"

namespace lab_02 {
// A namespace of its own: a function or type of yours in student.cpp may have the name of one of
// these, and does not replace it.
inline namespace inputs {

using glassbox::labs::Choices;
using glassbox::labs::InputClass;

// ---- turns of the plane (task 2.1) ----

// -360 to 360 degrees: quarters of a right angle, numbers of few digits, tiny angles, any angle.
inline double any_degrees(Choices& c) {
  switch (c.below(4)) {
    case 0:
      return double(c.integer(-16, 16)) * 22.5;
    case 1:
      return c.multiple(-360, 360, 8);
    case 2:
      return c.real(-1074, 7);  // below 2^8 = 256 degrees
    default: {
      const double degrees = std::ldexp(double(c.integer(-(1LL << 53), 1LL << 53)), -53) * 360;
      return std::clamp(degrees, -360.0, 360.0);
    }
  }
}

// A coordinate of any size up to 2^highest, or 0.
inline double any_coordinate(Choices& c, int lowest, int highest) {
  switch (c.below(3)) {
    case 0:
      return c.one_of({0.0, -0.0});
    case 1:
      return double(c.integer(-9, 9));
    default:
      return c.real(lowest, highest);
  }
}

inline TurnCase a_turn(Choices& c, int lowest, int highest) {
  const double x = any_coordinate(c, lowest, highest), y = any_coordinate(c, lowest, highest);
  return {{x, y}, any_degrees(c)};
}

inline TurnCase turn_about_origin(Choices& c) {
  return {{0, 0}, any_degrees(c)};
}

inline std::vector<InputClass<TurnCase>> generated_turns() {
  return {{"about the origin", 10'000, turn_about_origin},
          {"about points of usual size", 20'000, [](Choices& c) { return a_turn(c, -10, 10); }},
          {"about points of every size", 10'000, [](Choices& c) { return a_turn(c, -1074, 999); }}};
}

// ---- steps (task 2.2) ----

// A vector of integers up to `reach` in size, not 0: every pattern of signs and zeros.
inline Vector<World, double> small_vector(Choices& c, std::int64_t reach) {
  const auto x = double(c.integer(-reach, reach)), y = double(c.integer(-reach, reach));
  const auto z = double(c.integer(-reach, reach));
  if (x == 0 && y == 0 && z == 0) return {0, 0, 1};
  return {x, y, z};
}

// An axis of any direction and any length, from the smallest double to the largest.
inline Vector<World, double> any_axis(Choices& c) {
  const Vector<World, double> small = small_vector(c, 4);
  switch (c.below(4)) {
    case 0:
      return small;
    case 1: {  // components of similar sizes, all very small or very large
      const auto exponent = int(c.integer(-1074, 1021));
      return {std::ldexp(small.x, exponent), std::ldexp(small.y, exponent),
              std::ldexp(small.z, exponent)};
    }
    case 2: {  // almost along an axis
      const double off = std::ldexp(1, int(c.integer(-60, 0)));
      return {small.x, small.y * off, small.z == 0 ? 1 : small.z};
    }
    default: {
      const double x = c.real(-3, 3), y = c.real(-3, 3);
      return {x, y, c.real(-3, 3)};
    }
  }
}

inline double any_factor(Choices& c) {
  return c.flag() ? c.one_of({1.0, -1.0, 0.0, -0.0, 0.5, -2.0}) : c.real(-12, 12);
}

inline Step any_step(Choices& c) {
  switch (c.below(4)) {
    case 0: {
      const double x = any_coordinate(c, -20, 20), y = any_coordinate(c, -20, 20);
      return move(x, y, any_coordinate(c, -20, 20));
    }
    case 1: {
      const Vector<World, double> axis = any_axis(c);
      return turn(axis.x, axis.y, axis.z, any_degrees(c));
    }
    case 2: {
      const double x = any_factor(c), y = any_factor(c);
      return scale(x, y, any_factor(c));
    }
    default: {
      const auto changed = int(c.below(3)), further = int(c.below(2));
      return shear(changed, (changed + 1 + further) % 3, any_factor(c));
    }
  }
}

inline ComposeCase one_step(Choices& c) {
  return {"one step", {any_step(c)}};
}
inline ComposeCase one_turn(Choices& c) {
  const Vector<World, double> axis = any_axis(c);
  return {"a turn", {turn(axis.x, axis.y, axis.z, any_degrees(c))}};
}
inline ComposeCase some_steps(Choices& c) {
  ComposeCase made{"steps", {}};
  const std::uint64_t count = 2 + c.below(5);
  for (std::uint64_t i = 0; i < count; ++i) made.steps.push_back(any_step(c));
  return made;
}
inline ComposeCase many_steps(Choices& c) {
  ComposeCase made{"many steps", {}};
  const std::uint64_t count = c.below(41);
  for (std::uint64_t i = 0; i < count; ++i) {
    const Vector<World, double> v = small_vector(c, 3);
    if (c.flag()) {
      made.steps.push_back(turn(v.x, v.y, v.z, any_degrees(c)));
    } else {
      made.steps.push_back(move(v.x / 16, v.y / 16, v.z / 16));
    }
  }
  return made;
}

inline std::vector<InputClass<ComposeCase>> generated_compositions() {
  return {{"one step of each kind", 15'000, one_step},
          {"turns about axes of every direction and length", 10'000, one_turn},
          {"two to six steps in any order", 15'000, some_steps},
          {"up to 40 turns and small moves", 1'000, many_steps}};
}

// ---- three points (task 2.3) ----

inline constexpr std::int64_t kFarthest = std::int64_t(1) << 20;  // the largest coordinate

inline double inside(std::int64_t at) {
  return double(std::clamp(at, -kFarthest, kFarthest));
}
inline Point2 any_point(Choices& c) {
  const std::int64_t x = c.sized(20);
  return {double(x), double(c.sized(20))};
}
inline Point2 point_within(Choices& c, std::int64_t reach) {
  const std::int64_t x = c.integer(-reach, reach);
  return {double(x), double(c.integer(-reach, reach))};
}
inline Point2 shifted(const Point2& p, std::int64_t x, std::int64_t y) {
  return {inside(std::int64_t(p.x) + x), inside(std::int64_t(p.y) + y)};
}

inline std::array<Point2, 3> any_target(Choices& c) {
  switch (c.below(4)) {
    case 0: {
      const Point2 p = point_within(c, 4), q = point_within(c, 4);
      return {p, q, point_within(c, 4)};
    }
    case 1: {  // on a line, or all in one place
      const Point2 p = any_point(c);
      const std::int64_t x = c.integer(-3, 3), y = c.integer(-3, 3), t = c.integer(-3, 3);
      return {p, shifted(p, x, y), shifted(p, x * t, y * t)};
    }
    default: {
      const Point2 p = any_point(c), q = any_point(c);
      return {p, q, any_point(c)};
    }
  }
}

inline FitCase fit_of(Choices& c, const std::array<Point2, 3>& source) {
  return {"three points", source, any_target(c)};
}

// Three points in any order.
inline std::array<Point2, 3> in_any_order(Choices& c, std::array<Point2, 3> p) {
  const std::uint64_t first = c.below(3), second = c.below(2);
  std::swap(p[0], p[first]);
  std::swap(p[1], p[1 + second]);
  return p;
}

// Three points that are as near to a line as integers allow, or on it: twice their area is 0, 1, 2
// or 3 times the greatest common divisor of one edge's coordinates. The edge has any length up to
// that of the whole range of coordinates.
inline FitCase needle(Choices& c) {
  const bool of_any_size = !c.flag();
  const std::int64_t dx = of_any_size ? c.sized(20) : c.integer(-2 * kFarthest, 2 * kFarthest);
  const std::int64_t dy = of_any_size ? c.sized(20) : c.integer(-2 * kFarthest, 2 * kFarthest);
  const auto [u, v] = glassbox::labs::bezout(dx, dy);
  const std::int64_t off = c.integer(-3, 3);
  std::int64_t x = -off * v, y = off * u;
  if (x * dx + y * dy < 0) x += dx, y += dy;  // not behind the edge's first point
  const Point2 p{inside(-dx / 2), inside(-dy / 2)};
  return fit_of(c, in_any_order(c, {p, shifted(p, dx, dy), shifted(p, x, y)}));
}

// Three points on a line: `at` and multiples of a small vector from it.
inline FitCase on_a_line(Choices& c) {
  const std::int64_t x = c.integer(-40, 40), y = c.integer(-40, 40);
  const std::int64_t farthest = std::max({std::int64_t(1), std::abs(x), std::abs(y)});
  const std::int64_t reach = kFarthest / 2 / farthest;
  const Point2 at = point_within(c, kFarthest / 2);
  const std::int64_t s = c.integer(-reach, reach), t = c.integer(-reach, reach);
  return fit_of(c, in_any_order(c, {at, shifted(at, x * s, y * s), shifted(at, x * t, y * t)}));
}

inline std::vector<InputClass<FitCase>> generated_fits() {
  return {{"small triangles", 10'000,
           [](Choices& c) {
             const Point2 p = point_within(c, 3), q = point_within(c, 3);
             return fit_of(c, {p, q, point_within(c, 3)});
           }},
          {"triangles of every size", 20'000,
           [](Choices& c) {
             const Point2 p = any_point(c), q = any_point(c);
             return fit_of(c, {p, q, any_point(c)});
           }},
          {"small triangles far from the origin", 10'000,
           [](Choices& c) {
             const Point2 p = point_within(c, kFarthest);
             const std::int64_t qx = c.integer(-5, 5), qy = c.integer(-5, 5);
             const std::int64_t rx = c.integer(-5, 5), ry = c.integer(-5, 5);
             return fit_of(c, {p, shifted(p, qx, qy), shifted(p, rx, ry)});
           }},
          {"points on a line, and points that are the same", 15'000, on_a_line},
          {"needles of every length, as near to a line as integers allow", 15'000, needle}};
}

// ---- rotations (tasks 2.4 and 2.5) ----

inline RotationCase rotation_by(std::int64_t w, const Vector<World, double>& v) {
  return {"a rotation", std::int32_t(w), std::int32_t(v.x), std::int32_t(v.y), std::int32_t(v.z)};
}

// An axis of whole numbers up to 2^bits in size.
inline Vector<World, double> whole_axis(Choices& c, int bits) {
  const auto x = double(c.sized(bits)), y = double(c.sized(bits)), z = double(c.sized(bits));
  if (x == 0 && y == 0 && z == 0) return {0, 0, 1};
  return {x, y, z};
}

// By 90 degrees or a little more or less: |v| is the whole number w, or w +- 1.
inline RotationCase right_angle(Choices& c) {
  static constexpr int kLengths[][4] = {{1, 0, 0, 1}, {1, 2, 2, 3},  {2, 3, 6, 7},
                                        {3, 4, 0, 5}, {1, 4, 8, 9},  {2, 6, 9, 11},
                                        {4, 4, 7, 9}, {6, 6, 7, 11}, {5, 12, 0, 13}};
  const auto& row = kLengths[c.below(std::size(kLengths))];
  const std::uint64_t turn = c.below(3);
  const std::int64_t times = std::int64_t(1) << c.below(18);
  double v[3];
  for (double& each : v) each = c.flag() ? -1 : 1;
  for (std::size_t i = 0; i < 3; ++i) v[(i + turn) % 3] *= double(row[i] * times);
  return rotation_by(row[3] * times + c.integer(-1, 1), {v[0], v[1], v[2]});
}

inline std::vector<InputClass<RotationCase>> generated_rotations() {
  return {{"small whole numbers", 15'000,
           [](Choices& c) {
             const std::int64_t w = c.integer(0, 4);
             return rotation_by(w, small_vector(c, 4));
           }},
          {"half turns about axes of every pattern of signs (C-05)", 15'000,
           [](Choices& c) {
             return rotation_by(0, c.flag() ? small_vector(c, 2) : whole_axis(c, 24));
           }},
          {"almost half a turn (C-05)", 15'000,
           [](Choices& c) {
             const std::int64_t w = c.integer(1, 8);
             return rotation_by(w, whole_axis(c, 24));
           }},
          {"angles from 10^-6 on (C-04)", 15'000,
           [](Choices& c) {
             // The angle is about 2 |v| / w, at least 2 / 2,000,000.
             const std::int64_t w = c.integer(1, 2'000'000);
             return rotation_by(w, small_vector(c, 3));
           }},
          {"a right angle, and a little more or less", 10'000, right_angle},
          {"angles of every size", 15'000, [](Choices& c) {
             const std::int64_t w = std::abs(c.sized(20));
             return rotation_by(w, whole_axis(c, 20));
           }}};
}

// The largest entry of R^T R - I in size. It is computed in double, whose rounding does not matter
// here.
inline double drift_of(const Transform<World, World>& r) {
  double largest = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      double sum = i == j ? -1 : 0;
      for (int k = 0; k < 3; ++k) sum += r.at(k, i) * r.at(k, j);
      largest = std::max(largest, std::abs(sum));
    }
  }
  return largest;
}

// A rotation of which some entries are changed. The largest entry of R^T R - I stays below 0.01:
// the changes are halved until it does.
inline DriftCase a_drift(Choices& c, int lowest, int highest) {
  const std::int64_t w = c.integer(0, 9);
  const auto rotation =
      rotation_of(rotation_by(w, c.flag() ? small_vector(c, 3) : whole_axis(c, 10)));
  const double size = std::ldexp(1, int(c.integer(lowest, highest)));
  const std::uint64_t kind = c.below(3);
  double change[3][3] = {};
  if (kind == 0) {  // every entry
    for (auto& row : change) {
      for (double& each : row) each = size * c.multiple(-1, 1, 256);
    }
  } else if (kind == 1) {  // the whole matrix is too long or too short
    const double by = size * c.multiple(-1, 1, 256);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) change[i][j] = by * rotation.at(i, j);
    }
  } else {  // one column leans towards another one
    const auto j = int(c.below(3)), to = int(c.below(3));
    const double by = size * c.multiple(-1, 1, 256);
    for (int i = 0; i < 3; ++i) change[i][j] = by * rotation.at(i, to);
  }
  for (double part = 1;; part /= 2) {
    DriftCase made{"a rotation with errors", rotation};
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) made.matrix.at(i, j) += part * change[i][j];
    }
    if (drift_of(made.matrix) < 0.00999) return made;
  }
}

inline std::vector<InputClass<DriftCase>> generated_drifts() {
  return {{"errors as large as is allowed", 10'000, [](Choices& c) { return a_drift(c, -8, -5); }},
          {"errors of every size", 10'000, [](Choices& c) { return a_drift(c, -60, -9); }}};
}

}  // namespace inputs
}  // namespace lab_02
