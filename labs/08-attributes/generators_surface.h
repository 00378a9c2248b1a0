// The generated inputs of lab 8 for curved surfaces: of all kinds that student.h names and of the
// borders between them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "cases.h"
#include "labs/framework/choices.h"

namespace lab_08 {
// A namespace of its own: a function or type of yours in student.cpp may have the name of one of
// these, and does not replace it.
inline namespace inputs {

using glassbox::labs::Choices;
using glassbox::labs::InputClass;

// ---- curved surfaces (tasks 8.5 and 8.6) ----

// A coordinate of a control point, which is 0 or from 2^-3 to 2^3 in magnitude, times 2^exponent.
inline double patch_coordinate(Choices& c, int exponent) {
  switch (c.below(3)) {
    case 0:
      return std::ldexp(double(c.integer(-4, 4)), exponent);
    case 1:
      return std::ldexp(c.multiple(-8, 8, 8), exponent);
    default:
      return std::ldexp(c.real(-3, 2), exponent);
  }
}
inline Point<Object, double> any_control_point(Choices& c, int exponent) {
  const double x = patch_coordinate(c, exponent);
  const double y = patch_coordinate(c, exponent);
  return {x, y, patch_coordinate(c, exponent)};
}
inline int any_exponent(Choices& c) {
  return c.flag() ? 0 : int(c.integer(-96, 96));
}
inline Patch any_patch(Choices& c, int exponent) {
  Patch patch;
  for (auto& row : patch.rows) {
    for (auto& point : row) point = any_control_point(c, exponent);
  }
  return patch;
}
inline Patch any_patch(Choices& c) {
  return any_patch(c, any_exponent(c));
}

// A patch with coordinates of every size together.
inline Patch uneven_patch(Choices& c) {
  Patch patch;
  for (auto& row : patch.rows) {
    for (auto& point : row) {
      const auto exponent = int(c.integer(-96, 96));
      point = any_control_point(c, exponent);
    }
  }
  return patch;
}

inline PatchCase one_patch(const Patch& patch, int level) {
  return {"a patch", patch, level};
}

// A row or column that is one point, nearly so, or in which some points are the same.
inline Patch patch_with_equal_points(Choices& c) {
  const int exponent = any_exponent(c);
  Patch patch = any_patch(c, exponent);
  const auto which = c.below(6);  // rows[0] most often
  const bool last = which == 3 || which == 5, column = which >= 4;
  const bool same = c.flag();
  std::array<std::size_t, 4> from{};
  for (std::size_t& each : from) each = same ? 0 : c.below(4);
  const Patch before = patch;
  const auto at = [&](auto& of, std::size_t i) -> auto& {
    const std::size_t line = last ? 3 : 0;
    return column ? of.rows[i][line] : of.rows[line][i];
  };
  for (std::size_t i = 0; i < 4; ++i) at(patch, i) = at(before, from[i]);
  // One coordinate of one point is moved to the next double.
  if (c.flag()) {
    auto& point = at(patch, c.below(4));
    double* coordinates[3] = {&point.x, &point.y, &point.z};
    double& moved = *coordinates[c.below(3)];
    moved = moved == 0 ? 0x1p-100 : std::nextafter(moved, 0.0);
  }
  return patch;
}

inline std::vector<InputClass<PatchCase>> generated_patches() {
  return {{"patches up to 8 x 8 cells", 3'000,
           [](Choices& c) {
             const int level = 1 + int(c.below(8));
             return one_patch(any_patch(c), level);
           }},
          {"rows and columns in which points are the same, poles among them", 4'000,
           [](Choices& c) {
             const int level = 1 + int(c.below(4));
             return one_patch(patch_with_equal_points(c), level);
           }},
          {"coordinates of every size in one patch", 1'000,
           [](Choices& c) {
             const int level = 1 + int(c.below(8));
             return one_patch(uneven_patch(c), level);
           }},
          {"up to 40 x 40 cells", 150,
           [](Choices& c) {
             const int level = 1 + int(c.below(40));
             return one_patch(c.flag() ? any_patch(c) : patch_with_equal_points(c), level);
           }},
          // The answers to a class may have 64 MiB, of which 256 x 256 cells take a quarter.
          {"100 to 255 cells along a side", 1,
           [](Choices& c) {
             const int level = 100 + int(c.below(156));
             return one_patch(any_patch(c), level);
           }},
          {"256 x 256 cells", 1, [](Choices& c) { return one_patch(any_patch(c), 256); }}};
}

// Two patches with a common border, each of which has other points everywhere else.
inline SeamCase patches_that_meet(Choices& c, int levels) {
  const int level = 1 + int(c.below(std::uint64_t(levels)));
  const Border border = c.one_of({Border::kFirstRow, Border::kFirstColumn, Border::kLastColumn});
  Patch a = c.flag() ? uneven_patch(c) : any_patch(c);
  const Patch b = c.flag() ? uneven_patch(c) : any_patch(c);
  if (c.flag()) {
    const auto to = std::size_t(c.below(4));
    a.rows[3][to] = a.rows[3][c.below(4)];
  }
  SeamCase made{"two patches", a, b, border, level};
  for (std::size_t t = 0; t < 4; ++t) {
    const auto& point = a.rows[3][3 - t];
    if (border == Border::kFirstRow) made.b.rows[0][t] = point;
    if (border == Border::kFirstColumn) made.b.rows[t][0] = point;
    if (border == Border::kLastColumn) made.b.rows[t][3] = point;
  }
  return made;
}

inline std::vector<InputClass<SeamCase>> generated_seams() {
  return {
      {"patches up to 16 x 16 cells", 4'000, [](Choices& c) { return patches_that_meet(c, 16); }},
      {"patches up to 128 x 128 cells", 60, [](Choices& c) { return patches_that_meet(c, 128); }}};
}

// A patch and its level, with tolerances that need from less than one cell to more than 256.
inline LevelCase one_level(Choices& c, const Patch& patch, int exponent) {
  const double px_per_unit = std::ldexp(c.positive(-3, 2), -exponent);
  return {"a patch", patch, px_per_unit, c.positive(-9, 7)};
}

// A flat patch of which one control point is moved.
inline LevelCase one_point_moved(Choices& c) {
  const auto exponent = int(c.integer(-90, 90));
  const double size = std::ldexp(1.0, exponent);
  Patch patch;
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t i = 0; i < 4; ++i) patch.rows[j][i] = {double(i) * size, 0, double(j) * size};
  }
  const auto row = std::size_t(c.below(4)), column = std::size_t(c.below(4));
  patch.rows[row][column] = any_control_point(c, exponent);
  return one_level(c, patch, exponent);
}

// The patch (a i^2, b j^2, d i j), of which every difference is the same, with the tolerance that
// `level` cells just reach, or one beside it. The left side is (12 |a| + 18 |d| + 12 |b|)
// px_per_unit / (8 level^2).
inline LevelCase tolerance_at_border(Choices& c) {
  const auto exponent = int(c.integer(-90, 89));
  const double unit = std::ldexp(c.positive(0, 0), exponent);
  const double a = double(c.integer(-8, 8)) * unit, b = double(c.integer(-8, 8)) * unit;
  const double d = double(c.integer(-8, 8)) * unit;
  const auto axis = c.below(3);
  Patch patch;
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t i = 0; i < 4; ++i) {
      std::array<double, 3> p{a * double(i * i), b * double(j * j), d * double(i * j)};
      std::rotate(p.begin(), p.begin() + std::ptrdiff_t(axis), p.end());
      patch.rows[j][i] = {p[0], p[1], p[2]};
    }
  }
  const double px_per_unit = std::ldexp(c.positive(-3, 2), -exponent);
  const auto level = double(1 + c.below(256));
  const double left = (12 * std::abs(a) + 18 * std::abs(d) + 12 * std::abs(b)) / 8 * px_per_unit;
  const auto size = int(14 + c.below(26));
  const double beside = std::ldexp(double(c.integer(-2, 2)), -size);
  const double tolerance = left / (level * level) * (1 + beside);
  return {"a patch", patch, px_per_unit, tolerance == 0 ? 1 : tolerance};
}

// The same patch on one axis, of whole numbers so small that nothing rounds: 216 * 2^16 at most.
// a, b and d are multiples of level^2, so the tolerance is a multiple of px_per_unit / 8.
inline LevelCase tolerance_on_border(Choices& c) {
  const auto level = std::int64_t(1 + c.below(256)), squared = level * level;
  const std::int64_t a = c.integer(-8, 8), b = c.integer(-8, 8), d = c.integer(-8, 8);
  const auto axis = c.below(3);
  Patch patch;
  for (std::int64_t j = 0; j < 4; ++j) {
    for (std::int64_t i = 0; i < 4; ++i) {
      std::array<double, 3> p{double(squared * (a * i * i + b * j * j + d * i * j)), 0, 0};
      std::rotate(p.begin(), p.begin() + std::ptrdiff_t(axis), p.end());
      patch.rows[std::size_t(j)][std::size_t(i)] = {p[0], p[1], p[2]};
    }
  }
  const double px_per_unit = std::ldexp(1.0, int(c.integer(-20, 20)));
  const std::int64_t left = 12 * std::abs(a) + 18 * std::abs(d) + 12 * std::abs(b);
  const std::int64_t eighths = std::max<std::int64_t>(1, left + c.integer(-1, 1));
  return {"a patch", patch, px_per_unit, double(eighths) / 8 * px_per_unit};
}

inline std::vector<InputClass<LevelCase>> generated_levels() {
  return {{"patches of every size", 30'000,
           [](Choices& c) {
             const auto exponent = c.flag() ? 0 : int(c.integer(-90, 90));
             return one_level(c, any_patch(c, exponent), exponent);
           }},
          {"flat patches of which one control point is moved", 30'000, one_point_moved},
          {"tolerances next to the error of a level", 20'000, tolerance_at_border},
          {"whole numbers with which nothing rounds", 5'000, tolerance_on_border},
          {"patches that are a line or a point", 5'000,
           [](Choices& c) {
             const auto exponent = int(c.integer(-90, 90));
             Patch patch;
             const auto start = any_control_point(c, exponent);
             const auto end = any_control_point(c, exponent);
             const bool along_rows = c.flag();
             for (std::size_t j = 0; j < 4; ++j) {
               for (std::size_t i = 0; i < 4; ++i)
                 patch.rows[j][i] = (along_rows ? i : j) < 2 ? start : end;
             }
             return one_level(c, patch, exponent);
           }},
          {"tolerances of every size", 5'000, [](Choices& c) {
             const Patch patch = any_patch(c, 0);
             const double px_per_unit = c.positive(-100, 99);
             return LevelCase{"a patch", patch, px_per_unit, c.positive(-100, 99)};
           }}};
}

}  // namespace inputs
}  // namespace lab_08
