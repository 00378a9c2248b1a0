// The generated inputs of lab 3: of all kinds that student.h names and of the borders between them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "cases.h"
#include "labs/framework/choices.h"

namespace lab_03 {
// A namespace of its own: a function or type of yours in student.cpp may have the name of one of
// these, and does not replace it.
inline namespace inputs {

using glassbox::labs::Choices;
using glassbox::labs::InputClass;

using Direction = Vector<World, double>;

// ---- directions ----

// Whole numbers up to `reach` in size, not all 0: every pattern of signs and zeros.
inline Direction whole_direction(Choices& c, std::int64_t reach) {
  const auto x = double(c.integer(-reach, reach)), y = double(c.integer(-reach, reach));
  const auto z = double(c.integer(-reach, reach));
  if (x == 0 && y == 0 && z == 0) return {0, 0, -1};
  return {x, y, z};
}

inline Direction any_direction(Choices& c) {
  if (c.flag()) return whole_direction(c, 4);
  const double x = c.real(-4, 1), y = c.real(-4, 1);
  return {x, y, c.real(-4, 1)};
}

// The vector times 2^exponent.
inline Direction scaled(const Direction& v, std::int64_t exponent) {
  const int by = int(exponent);
  return {std::ldexp(v.x, by), std::ldexp(v.y, by), std::ldexp(v.z, by)};
}

inline Direction of_length_one(const Direction& v) {
  const double length = std::sqrt(dot(v, v));
  return {v.x / length, v.y / length, v.z / length};
}

// Two perpendicular directions of length 1, up to rounding.
struct Pair {
  Direction along, across;
};
inline Pair perpendicular_pair(Choices& c) {
  const Direction along = of_length_one(any_direction(c));
  Direction across = cross(along, any_direction(c));
  if (dot(across, across) < 0x1p-20)
    across = cross(along, std::abs(along.x) < 0.6 ? Direction{1, 0, 0} : Direction{0, 1, 0});
  return {along, of_length_one(across)};
}

// ---- cameras (tasks 3.1 and 3.3) ----

inline CameraCase camera_of(const Point<World, double>& eye, const Direction& gaze,
                            const Direction& up) {
  return {"a camera", {eye, {eye.x + gaze.x, eye.y + gaze.y, eye.z + gaze.z}, up}};
}

inline Point<World, double> any_eye(Choices& c, int highest) {
  if (c.flag()) {
    const Direction v = whole_direction(c, 5);
    return {v.x, v.y, v.z + 1};
  }
  const double x = c.real(-8, highest), y = c.real(-8, highest);
  return {x, y, c.real(-8, highest)};
}

// Whole numbers: the target may be the eye, and `up` may be zero or along the gaze.
inline CameraCase camera_of_whole_numbers(Choices& c) {
  double v[9];
  for (double& each : v) each = double(c.integer(-3, 3));
  return {"a camera", {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}}};
}

// A gaze and an `up` of any direction, not on one line, and of any lengths up to those that are
// allowed. The eye is at the origin, or as far away as the gaze is long.
inline CameraCase camera_of_any_lengths(Choices& c) {
  const auto [along, across] = perpendicular_pair(c);
  const double part = c.multiple(-2, 2, 8);
  const std::int64_t gaze_exponent = c.integer(-328, 328), up_exponent = c.integer(-328, 328);
  const Direction eye = c.flag() ? scaled(whole_direction(c, 4), gaze_exponent) : Direction{};
  return camera_of({eye.x, eye.y, eye.z}, scaled(along, gaze_exponent),
                   scaled(across + along * part, up_exponent));
}

// `up` and the gaze, or its opposite, have an angle of the given tangent. Its sine is nearly the
// same if it is small.
inline CameraCase camera_with_tangent(Choices& c, double tangent) {
  const auto [along, across] = perpendicular_pair(c);
  const double sign = c.flag() ? -1 : 1;
  const Direction eye = c.flag() ? whole_direction(c, 4) : Direction{};
  const std::int64_t up_exponent = c.integer(-40, 40);
  return camera_of({eye.x, eye.y, eye.z}, along,
                   scaled(along * sign + across * tangent, up_exponent));
}

// On both sides of the smallest sine, 2^-20, but no nearer than 2^-26 of it.
inline CameraCase camera_at_smallest_sine(Choices& c) {
  const double apart = std::ldexp(1, -int(c.integer(1, 26)));
  return camera_with_tangent(c, 0x1p-20 * (1 + (c.flag() ? -apart : apart)));
}

inline CameraCase camera_far_away(Choices& c) {
  const Point<World, double> eye = any_eye(c, 40);
  const Direction gaze = whole_direction(c, 9);
  // An `up` that cannot be along the gaze: the two differ in one coordinate's share.
  const Direction other = whole_direction(c, 9), across = cross(gaze, other);
  return camera_of(eye, gaze, dot(across, across) > 0 ? other : Direction{gaze.y, gaze.z, 10});
}

// A gaze along +z or -z, exactly or almost: its x and y are less than an eighth of its z. `up` is
// not along it: its x or y is at least a quarter of its z.
inline CameraCase camera_along_z(Choices& c) {
  const double z = c.flag() ? -1 : 1;
  const double x = c.flag() ? c.real(-40, -4) : 0, y = c.flag() ? c.real(-40, -4) : 0;
  Direction up = whole_direction(c, 4);
  if (up.x == 0 && up.y == 0) up.y = 1;
  const Direction eye = c.flag() ? whole_direction(c, 4) : Direction{};
  return camera_of({eye.x, eye.y, eye.z}, {x, y, z}, up);
}

// One of the nine numbers is infinite or NaN.
inline CameraCase camera_with_infinity(Choices& c) {
  CameraCase made = camera_along_z(c);
  Camera& camera = made.camera;
  double* const all[] = {&camera.eye.x,    &camera.eye.y,    &camera.eye.z,
                         &camera.target.x, &camera.target.y, &camera.target.z,
                         &camera.up.x,     &camera.up.y,     &camera.up.z};
  const std::uint64_t which = c.below(9);
  *all[which] = c.one_of({HUGE_VAL, -HUGE_VAL, std::numeric_limits<double>::quiet_NaN()});
  return made;
}

// The cameras that have a view, for both constructions.
inline std::vector<InputClass<CameraCase>> generated_views() {
  return {{"gaze along the z axis, exactly and almost (C-05)", 8'000, camera_along_z},
          {"vectors of every direction and length", 10'000, camera_of_any_lengths},
          {"`up` near the gaze (C-01)", 8'000,
           [](Choices& c) {
             const double tangent = std::ldexp(1, -int(c.integer(0, 19)));
             return camera_with_tangent(c, tangent);
           }},
          {"eyes far from the origin (C-13)", 8'000, camera_far_away}};
}

inline std::vector<InputClass<CameraCase>> generated_cameras() {
  std::vector<InputClass<CameraCase>> all = generated_views();
  all.push_back({"whole numbers: no gaze, no `up`, `up` along the gaze (C-02, C-03)", 8'000,
                 camera_of_whole_numbers});
  all.push_back(
      {"`up` on both sides of the smallest angle (C-01)", 8'000, camera_at_smallest_sine});
  all.push_back({"`up` along the gaze, up to rounding (C-01)", 2'000, [](Choices& c) {
                   const double tangent = c.flag() ? c.real(-60, -22) : 0;
                   return camera_with_tangent(c, tangent);
                 }});
  all.push_back({"a number that is infinite or NaN (C-03)", 2'000, camera_with_infinity});
  return all;
}

// ---- directions onto directions (task 3.2) ----

// Whether two vectors are both along x, both along y or both along z.
inline bool along_one_axis(const Direction& a, const Direction& b) {
  const int x = a.x != 0 || b.x != 0 ? 1 : 0, y = a.y != 0 || b.y != 0 ? 1 : 0;
  return x + y + (a.z != 0 || b.z != 0 ? 1 : 0) == 1;
}

inline OntoCase onto(const Direction& from, const Direction& to) {
  return {"two directions", from, to};
}

// Directions of whole numbers, of any lengths. Opposite ones have the same length, or are both
// along x, y or z.
inline OntoCase onto_of_whole_numbers(Choices& c) {
  const Direction from = whole_direction(c, 3), to = whole_direction(c, 3);
  const Direction across = cross(from, to);
  const bool opposite = dot(across, across) == 0 && dot(from, to) < 0;
  const bool any_lengths = c.flag();
  const std::int64_t a = any_lengths ? c.integer(-1074, 1020) : 0;
  const std::int64_t b = any_lengths ? c.integer(-1074, 1020) : 0;
  if (opposite && !along_one_axis(from, to)) return onto(scaled(from, a), -scaled(from, a));
  return onto(scaled(from, a), scaled(to, b));
}

// Directions `off` from each other, or from the opposite of each other, or from a right angle.
inline OntoCase onto_nearly(Choices& c, double onward, int lowest) {
  const auto [along, across] = perpendicular_pair(c);
  const double off = c.real(lowest, -1);
  const std::int64_t a = c.integer(-300, 300), b = c.integer(-300, 300);
  const Direction to = onward == 0 ? across + along * off : along * onward + across * off;
  return onto(scaled(along, a), scaled(to, b));
}

inline OntoCase half_turn(Choices& c) {
  if (c.flag()) {  // along an axis, of any lengths
    const std::uint64_t axis = c.below(3);
    const double a = std::abs(c.real(-1074, 1022)), b = std::abs(c.real(-1074, 1022));
    const double sign = c.flag() ? -1 : 1;
    const auto unit = [&](double length) {
      return Direction{axis == 0 ? length : 0, axis == 1 ? length : 0, axis == 2 ? length : 0};
    };
    return onto(unit(sign * a), unit(-sign * b));
  }
  const Direction direction = any_direction(c);
  const Direction from = scaled(direction, c.integer(-300, 300));
  return onto(from, -from);
}

inline OntoCase onto_any(Choices& c) {
  const auto [along, across] = perpendicular_pair(c);
  return onto(along, across + along * c.multiple(-4, 4, 16));
}
inline OntoCase onto_nearly_same(Choices& c) {
  return onto_nearly(c, 1, -52);
}
inline OntoCase onto_nearly_opposite(Choices& c) {
  return onto_nearly(c, -1, -40);
}
inline OntoCase onto_nearly_right_angle(Choices& c) {
  return onto_nearly(c, 0, -60);
}

inline std::vector<InputClass<OntoCase>> generated_directions() {
  return {{"whole numbers of every length", 20'000, onto_of_whole_numbers},
          {"directions of every kind", 15'000, onto_any},
          {"nearly the same direction (C-04)", 10'000, onto_nearly_same},
          {"nearly opposite directions (C-05)", 15'000, onto_nearly_opposite},
          {"nearly a right angle", 5'000, onto_nearly_right_angle},
          {"half turns about axes of every pattern of signs (C-05)", 15'000, half_turn}};
}

// ---- matrices (task 3.4) ----

// The rotation of the quaternion (w; x, y, z) of whole numbers, whose entries are rounded once.
inline Transform<World, World> whole_rotation(Choices& c) {
  const auto w = double(c.integer(0, 4));
  const Direction axis = whole_direction(c, 4);
  const double v[3] = {axis.x, axis.y, axis.z}, n = w * w + dot(axis, axis);
  Transform<World, World> m;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    m.at(i, i) = (w * w + v[i] * v[i] - v[j] * v[j] - v[k] * v[k]) / n;
    m.at(i, j) = 2 * (v[i] * v[j] - w * v[k]) / n;
    m.at(j, i) = 2 * (v[i] * v[j] + w * v[k]) / n;
  }
  return m;
}

// A rotation, or a mirror: one row or column reversed, all reversed, or two columns exchanged. The
// last row and column, which do not matter, have any numbers.
inline Transform<World, World> rotation_or_mirror(Choices& c) {
  Transform<World, World> m = whole_rotation(c);
  const std::uint64_t kind = c.below(5), which = c.below(3);
  const auto at = int(which), next = int((which + 1) % 3);
  for (int i = 0; i < 3; ++i) {
    if (kind == 1) m.at(i, at) = -m.at(i, at);
    if (kind == 2) m.at(at, i) = -m.at(at, i);
    if (kind == 3) std::swap(m.at(i, at), m.at(i, next));
    if (kind == 4) m.at(i, 0) = -m.at(i, 0), m.at(i, 1) = -m.at(i, 1), m.at(i, 2) = -m.at(i, 2);
  }
  if (c.flag()) {
    for (int i = 0; i < 4; ++i) {
      m.at(i, 3) = c.one_of({0.0, 1.0, -3.0, 1e9});
      m.at(3, i) = c.one_of({0.0, 1.0, -3.0, 1e9});
    }
  }
  return m;
}

// A rotation or mirror with an error of about `size`: an axis that is too long or too short, or
// that leans towards another one, or all axes that are too long or too short.
inline KindCase with_error(Choices& c, double size) {
  Transform<World, World> m = rotation_or_mirror(c);
  const double by = c.flag() ? -size : size;
  const auto at = int(c.below(3)), other = int(c.below(3));
  const std::uint64_t kind = c.below(3);
  for (int i = 0; i < 3; ++i) {
    if (kind == 0) m.at(i, at) += by * m.at(i, other);  // a column
    if (kind == 1) m.at(at, i) += by * m.at(other, i);  // a row
    for (int j = 0; j < 3 && kind == 2; ++j) m.at(i, j) *= 1 + by;
  }
  return {"a rotation or mirror with an error", m};
}

// Matrices that are neither: zero rows or columns, scales whose product is 1 or -1, columns of
// length 1 that are not perpendicular, numbers that are very large, very small, infinite or NaN.
inline KindCase neither(Choices& c) {
  Transform<World, World> m = rotation_or_mirror(c);
  const auto at = int(c.below(3)), other = int(c.below(3));
  const std::uint64_t kind = c.below(6);
  const auto exponent = int(c.integer(1, 600));
  for (int i = 0; i < 3; ++i) {
    if (kind == 0) m.at(i, at) = 0;
    if (kind == 1) m.at(at, i) = 0;
    if (kind == 2) m.at(i, at) *= 2, m.at(i, (at + 1) % 3) /= 2;
    if (kind == 3) m.at(i, at) = 0.8 * m.at(i, at) + 0.6 * m.at(i, (at + 1) % 3);
    if (kind == 4) m.at(i, at) = std::ldexp(m.at(i, at), other == 0 ? exponent : -exponent);
  }
  if (kind == 5)
    m.at(at, other) = c.one_of({HUGE_VAL, -HUGE_VAL, std::numeric_limits<double>::quiet_NaN()});
  return {"neither", m};
}

// The bounds of the sizes follow from R^T R - I for R = Q (I + E), where Q is a rotation or mirror:
// its largest entry is at most 2 |E| + |E|^2. If E has one entry, or is a multiple of I, the
// largest entry is at least |E| for a column, and at least sqrt(2)/3 |E| for a row.
inline KindCase with_small_error(Choices& c) {
  const double size = std::ldexp(1, -int(c.integer(22, 60)));
  return with_error(c, size * (1 + c.multiple(0, 1, 64)) / 2);
}
inline KindCase with_large_error(Choices& c) {
  const double size = std::ldexp(1, -int(c.integer(0, 12)));
  return with_error(c, size * (1 + c.multiple(0, 1, 64) / 2));
}
inline KindCase without_error(Choices& c) {
  return {"a rotation or mirror", rotation_or_mirror(c)};
}

inline std::vector<InputClass<KindCase>> generated_kinds() {
  return {{"rotations and mirrors, and what is beside the 3 x 3 part", 15'000, without_error},
          {"errors up to 10^-6 (C-12)", 15'000, with_small_error},
          {"errors of 10^-4 and more", 15'000, with_large_error},
          {"matrices that are far from every rotation and mirror", 10'000, neither}};
}

// ---- projections of a left-handed eye (task 3.5) ----

struct ProjectionCase {
  const char* what;
  Transform<Clip, Eye> matrix;
};

inline ProjectionCase any_projection(Choices& c) {
  Transform<Clip, Eye> m;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j)
      m.at(i, j) = c.flag() ? c.real(-20, 20) : c.one_of({0.0, 1.0, -0.0});
  }
  return {"any matrix", m};
}

// A projection whose window is anywhere on the near plane, or a parallel one.
inline ProjectionCase off_centre(Choices& c) {
  Transform<Clip, Eye> m;
  m.at(0, 0) = c.multiple(-4, 4, 8);
  m.at(1, 1) = c.multiple(-4, 4, 8);
  const double x = c.multiple(-2, 2, 8), y = c.multiple(-2, 2, 8);
  const bool parallel = c.flag();
  m.at(0, parallel ? 3 : 2) = x;
  m.at(1, parallel ? 3 : 2) = y;
  m.at(2, 2) = c.multiple(-2, 2, 16);
  m.at(2, 3) = c.multiple(-9, 9, 16);
  m.at(3, 2) = parallel ? 0 : 1;
  m.at(3, 3) = parallel ? 1 : 0;
  return {"a window anywhere", m};
}

inline std::vector<InputClass<ProjectionCase>> generated_projections() {
  return {{"perspective and parallel projections, with the window anywhere", 10'000, off_centre},
          {"matrices of any entries", 10'000, any_projection}};
}

}  // namespace inputs
}  // namespace lab_03
