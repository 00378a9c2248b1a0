// The generated inputs of lab 10: of all kinds that student.h names and of the borders between
// them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "cases.h"
#include "labs/framework/choices.h"

namespace lab_10 {
// A namespace of its own: a function or type of yours in student.cpp may have the name of one of
// these, and does not replace it.
inline namespace inputs {

using glassbox::labs::Choices;
using glassbox::labs::InputClass;

// ---- rotations and vectors ----

// A rotation: one of the 24 that exchange the axes or change their signs, and others with small
// whole quaternions; one by any angle about any axis; or one by a small angle, down to 2^-50.
inline Matrix any_rotation(Choices& c) {
  const std::uint64_t kind = c.below(3);
  if (kind == 0) {
    const auto w = double(c.integer(-1, 1)), x = double(c.integer(-1, 1));
    const auto y = double(c.integer(-1, 1)), z = double(c.integer(-1, 1));
    return w == 0 && x == 0 && y == 0 && z == 0 ? not_turned() : turned_by(w, x, y, z);
  }
  const double x = c.multiple(-1, 1, 1 << 20), y = c.multiple(-1, 1, 1 << 20);
  const double z = c.multiple(-1, 1, 1 << 20);
  if (kind == 1) return turned_by(c.multiple(-1, 1, 1 << 20) + 0x1p-30, x, y, z);
  const double size = std::ldexp(1.0, -int(c.below(51)));
  return turned_by(1, size * x, size * y, size * z);
}

// A vector: along an axis, with coordinates of one size, with coordinates of different sizes, or 0.
inline Vector any_vector(Choices& c) {
  const std::uint64_t kind = c.below(8);
  Vector v{0, 0, 0};
  if (kind == 0) return v;
  if (kind == 1) {
    v[c.below(3)] = c.flag() ? -1 : 1;
    return v;
  }
  for (double& x : v) x = kind < 5 ? c.multiple(-1, 1, 1 << 20) : c.real(-20, 20);
  if (length(v) == 0) v[0] = 1;
  return v;
}
inline Vector of_any_size(Choices& c, const Vector& v) {
  // Between 2^-100 and 2^100: the factor leaves room for vectors from 2^-20 to 2^22.
  return times(c.flag() ? std::ldexp(1.0, int(c.integer(-78, 76))) : 1, v);
}

inline PoseCase one_pose(Choices& c) {
  const Matrix rotation = any_rotation(c);
  const Vector shift = any_vector(c);
  return {"two cameras", {rotation, of_any_size(c, shift)}};
}
inline std::vector<InputClass<PoseCase>> generated_poses() {
  return {{"cameras in every direction, near and far", 20'000, one_pose}};
}

// ---- matrices ----

// Two cameras, given by the same three perpendicular directions as each of them sees these: the
// rows of `left` and of `right`. The right camera is `baseline` away from the left one along the
// third direction.
struct Frames {
  Matrix left{}, right{};
  double baseline = 1;
};
inline Frames any_frames(Choices& c) {
  const Matrix left = any_rotation(c);
  const Matrix right = any_rotation(c);
  return {left, right, c.one_of({1.0, 0.5, 2.0})};
}
// The matrix E that is made of these directions. No task gives them.
inline Matrix matrix_of_frames(const Frames& f) {
  Matrix e{};
  for (std::size_t i = 0; i < 3; ++i)
    e[i] =
        times(f.baseline, plus(times(f.right[1][i], f.left[0]), times(-f.right[0][i], f.left[1])));
  return e;
}
// The vector with the coordinates p in the three directions.
inline Vector along_frame(const Matrix& frame, const Vector& p) {
  return plus(times(p[0], frame[0]), plus(times(p[1], frame[1]), times(p[2], frame[2])));
}

// ---- lines (task 10.2) ----

inline Camera any_camera(Choices& c) {
  const double f = c.flag() ? std::ldexp(1.0, int(c.integer(0, 12))) : c.positive(-9, 18);
  const double x = c.flag() ? double(c.integer(0, 1000)) : c.real(-4, 12);
  return {f, x, c.flag() ? double(c.integer(0, 1000)) : c.real(-4, 12)};
}
inline Pixel any_pixel(Choices& c) {
  const double x = c.flag() ? c.multiple(-64, 1024, 16) : c.real(-4, 20);
  return {x, c.flag() ? c.multiple(-64, 1024, 16) : c.real(-4, 20)};
}
inline Matrix scaled(Choices& c, const Matrix& m) {
  if (!c.flag()) return m;
  const double sign = c.flag() ? -1 : 1;
  const double size = std::ldexp(sign, int(c.integer(-90, 90)));
  return {times(size, m[0]), times(size, m[1]), times(size, m[2])};
}
inline LineCase any_line(Choices& c) {
  const Matrix e = scaled(c, matrix_of_frames(any_frames(c)));
  const Camera left = any_camera(c), right = any_camera(c);
  return {"two cameras", e, left, right, any_pixel(c)};
}

// Whole numbers, so that nothing is rounded: a right camera that is turned by quarter turns, and a
// pixel that it sees on a row, on a column, at the epipole or at infinity.
inline Matrix quarter_turns(Choices& c) {
  const std::size_t first = c.below(3), second = (first + 1 + c.below(2)) % 3;
  Matrix m{};
  m[0][first] = c.flag() ? -1 : 1;
  m[1][second] = c.flag() ? -1 : 1;
  m[2] = cross(m[0], m[1]);
  return m;
}
inline LineCase exact_line(Choices& c) {
  const Matrix left_frame = quarter_turns(c);
  const Frames frames{left_frame, quarter_turns(c), 1};
  const Matrix e = scaled(c, matrix_of_frames(frames));
  const double f = std::ldexp(1.0, int(c.integer(0, 10)));
  const auto x = double(c.integer(0, 1000)), y = double(c.integer(0, 1000));
  const Camera left{f, x, y}, right = any_camera(c);
  const auto across = double(c.integer(-2, 2)), down = double(c.integer(-2, 2));
  return {"quarter turns", e, left, right, {x + f * across, y + f * down}};
}

// A pixel at a distance of 2^-60 to 1 of the epipole, in calibrated coordinates.
inline LineCase line_beside_epipole(Choices& c) {
  Frames frames = any_frames(c);
  if (std::abs(frames.left[2][2]) < 0.125) frames.left = quarter_turns(c);
  const Vector t = std::abs(frames.left[2][2]) < 0.125 ? Vector{0, 0, 1} : frames.left[2];
  const Matrix e = matrix_of_frames(frames);
  const Camera left = any_camera(c), right = any_camera(c);
  const double x = left.f * (t[0] / t[2] + (c.flag() ? c.real(-60, -1) : 0));
  const double y = left.f * (t[1] / t[2] + (c.flag() ? c.real(-60, -1) : 0));
  return {"beside the epipole", e, left, right, {x + left.x, y + left.y}};
}

inline std::vector<InputClass<LineCase>> generated_lines() {
  return {{"cameras and pixels of every kind", 30'000, any_line},
          {"rows, columns and no lines, without rounding", 10'000, exact_line},
          {"pixels beside the epipole", 10'000, line_beside_epipole}};
}

// ---- points (task 10.3) ----

// Points around a place that is at most 2^20 times as far away as their size.
inline PointsCase any_points(Choices& c, std::uint64_t most) {
  PointsCase made{"points", {}};
  const std::uint64_t kind = c.below(5), count = 2 + c.below(most - 1);
  const double far = c.flag() ? std::ldexp(1.0, int(c.below(21))) : 0;
  const double x = far * c.multiple(-1, 1, 8), y = far * c.multiple(-1, 1, 8);
  const double size = c.flag() ? std::ldexp(1.0, int(c.integer(-70, 70))) : 1;
  for (std::uint64_t i = 0; i < count; ++i) {
    // In a row, in a column, on a line, all but one in one place, or anywhere.
    double right = c.multiple(-1, 1, 1024), down = c.multiple(-1, 1, 1024);
    if (kind == 0 || (kind == 3 && i > 0)) down = 0;
    if (kind == 1 || (kind == 3 && i > 0)) right = 0;
    if (kind == 2) down = 3 * right;
    if (i == 0 && right == 0 && down == 0) (kind == 0 ? right : down) = 1;
    made.points.push_back({size * (x + right), size * (y + down)});
  }
  // Not all in one place, also if all the others are where the first one is.
  if (made.points[0].x == made.points[1].x && made.points[0].y == made.points[1].y)
    made.points[1] = {size * (x + 2), size * (y + 1)};
  return made;
}
inline std::vector<InputClass<PointsCase>> generated_points() {
  return {{"a few points", 15'000, [](Choices& c) { return any_points(c, 9); }},
          {"up to 200 points", 1'000, [](Choices& c) { return any_points(c, 200); }}};
}

// ---- matches (tasks 10.4 and 10.5) ----

// A point in front of both cameras and not beside the baseline, where it would have no depth. The
// coordinates of the point are those in the frame.
struct Seen {
  Match match;
  bool well = false;  // in front of both cameras, and its lines of sight cross
};
inline Seen seen_in_frames(const Frames& f, const Vector& point) {
  const Vector l = along_frame(f.left, point);
  const Vector r = along_frame(f.right, plus(point, {0, 0, -f.baseline}));
  Seen seen;
  seen.match = {{l[0] / l[2], l[1] / l[2]}, {r[0] / r[2], r[1] / r[2]}};
  const double across = point[0] * point[0] + point[1] * point[1];
  seen.well = l[2] > 0.25 && r[2] > 0.25 && across > 0.25;
  return seen;
}

// Frames of which `count` matches are seen; both cameras look roughly the same way.
struct Matches {
  Frames frames;
  std::vector<Match> matches;
};
inline Matches any_matches(Choices& c, std::size_t count) {
  Matches made;
  made.frames.left = any_rotation(c);
  const double x = c.multiple(-1, 1, 64) / 4, y = c.multiple(-1, 1, 64) / 4;
  const Matrix turn = turned_by(1, x, y, c.multiple(-2, 2, 64));
  for (std::size_t i = 0; i < 3; ++i) made.frames.right[i] = times(turn, made.frames.left[i]);
  made.frames.baseline = c.one_of({1.0, 0.5, 2.0});
  for (int tries = 0; tries < 400 && made.matches.size() < count; ++tries) {
    const double across = c.multiple(-1, 1, 1 << 12), down = c.multiple(-1, 1, 1 << 12);
    const double far = 1.5 + double(c.below(1 << 12)) / 512;
    // The point in the left camera's space, then in the frame.
    const Vector p{across * far, down * far, far};
    const Seen seen = seen_in_frames(made.frames, times(made.frames.left, p));
    if (seen.well) made.matches.push_back(seen.match);
  }
  // Enough matches of other cameras, if these have no common field of view.
  if (made.matches.size() < count) {
    made.frames = {turned_by(1, 0, 1, 0), turned_by(1, 0, 1, 0), 1};
    made.matches.clear();
    for (std::size_t i = 0; i < count; ++i) {
      const auto at = double(i);
      const Vector p{at * 0.25 - 1, 1 - double(i * i % 7) * 0.25, 3 + double(i * i * i % 11) * 0.5};
      made.matches.push_back(seen_in_frames(made.frames, times(made.frames.left, p)).match);
    }
  }
  return made;
}

inline MatchesCase matches_with_noise(Choices& c, std::size_t count, double noise) {
  Matches made = any_matches(c, count);
  for (Match& m : made.matches) {
    m.left.x += noise * c.multiple(-1, 1, 1024);
    m.left.y += noise * c.multiple(-1, 1, 1024);
    m.right.x += noise * c.multiple(-1, 1, 1024);
    m.right.y += noise * c.multiple(-1, 1, 1024);
  }
  return {"matches", {}, std::move(made.matches)};
}
inline std::vector<InputClass<MatchesCase>> generated_matches() {
  return {{"exact matches of cameras in every direction", 500,
           [](Choices& c) {
             const std::size_t count = 8 + c.below(13);
             return matches_with_noise(c, count, 0);
           }},
          {"matches with noise", 500, [](Choices& c) {
             const std::size_t count = 16 + c.below(25);
             return matches_with_noise(c, count, std::ldexp(1.0, -8 - int(c.below(12))));
           }}};
}

// `good` matches, and others that are wrong, but fewer. Only the right pose has all good ones in
// front of both cameras, and no other pose has any of them there, so whatever rounding makes of the
// wrong ones does not decide.
inline ChoiceCase one_choice(Choices& c, std::size_t good, std::size_t wrong) {
  Matches made = any_matches(c, good);
  const Matrix e = scaled(c, matrix_of_frames(made.frames));
  std::vector<Match> matches;
  for (std::size_t i = 0; i < wrong; ++i) {
    const double x = c.multiple(-1, 1, 64), y = c.multiple(-1, 1, 64);
    const double right_x = c.multiple(-1, 1, 64);
    matches.push_back({{x, y}, {right_x, c.multiple(-1, 1, 64)}});
  }
  // The wrong ones first or last.
  const auto place = c.flag() ? matches.end() : matches.begin();
  matches.insert(place, made.matches.begin(), made.matches.end());
  return {"two cameras", e, matches};
}
inline std::vector<InputClass<ChoiceCase>> generated_choices() {
  return {{"cameras in every direction, and one match or more", 3'000,
           [](Choices& c) {
             const std::size_t good = 1 + c.below(6);
             return one_choice(c, good, 0);
           }},
          {"cameras with some wrong matches", 2'000, [](Choices& c) {
             const std::size_t wrong = 1 + c.below(4);
             return one_choice(c, wrong + 3 + c.below(4), wrong);
           }}};
}

// ---- lines of sight (task 10.6) ----

inline Pixel any_calibrated(Choices& c) {
  const double x = c.flag() ? c.multiple(-2, 2, 16) : c.real(-30, 3);
  return {x, c.flag() ? c.multiple(-2, 2, 16) : c.real(-30, 3)};
}
inline RaysCase any_rays(Choices& c) {
  const Pixel left = any_calibrated(c), right = any_calibrated(c);
  const Matrix rotation = any_rotation(c);
  const Vector shift = any_vector(c);
  return {"two lines", left, right, {rotation, of_any_size(c, shift)}};
}

// Lines whose angle is 0 or between 2^-56 and 1: the right pixel is that of the infinitely far
// point of the left one, or beside it. Most angles are above 2^-24, as for much smaller ones the
// bound allows nearly every point.
inline RaysCase nearly_parallel_rays(Choices& c) {
  const Pixel left = any_calibrated(c);
  Matrix rotation = any_rotation(c);
  Vector p = times(rotation, Vector{left.x, left.y, 1});
  if (std::abs(p[2]) < 0.125) {
    rotation = not_turned();
    p = {left.x, left.y, 1};
  }
  Pixel right{p[0] / p[2], p[1] / p[2]};
  const int least = c.below(4) == 0 ? -56 : -24;
  right.x += c.flag() ? c.real(least, -1) : 0;
  right.y += c.flag() ? c.real(least, -1) : 0;
  const Vector shift = any_vector(c);
  return {"nearly parallel lines", left, right, {rotation, of_any_size(c, shift)}};
}

inline std::vector<InputClass<RaysCase>> generated_rays() {
  return {{"lines of every direction", 30'000, any_rays},
          {"lines that are parallel or nearly so, at every power of two", 30'000,
           nearly_parallel_rays}};
}

}  // namespace inputs
}  // namespace lab_10
