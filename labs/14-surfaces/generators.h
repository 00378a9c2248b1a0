// The generated inputs of lab 14: for each function inputs of all kinds that student.h names, and
// of the borders between them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "cases.h"
#include "labs/framework/choices.h"

namespace lab_14 {
// A namespace of its own: a function or type of yours in student.cpp may have the name of one of
// these, and does not replace it.
inline namespace inputs {

using glassbox::labs::Choices;
using glassbox::labs::InputClass;

// ---- cells (task 14.1) ----

inline CellCase any_cell(Choices& c) {
  return {"a cell", unsigned(c.below(256))};
}
inline std::vector<InputClass<CellCase>> generated_cells() {
  // So many that each of the 256 cells is among them, but for one time in 25,000.
  return {{"any corners inside", 4'000, any_cell}};
}

// ---- edges (task 14.2) ----

// An edge with one end at least at the level and the other below it.
inline EdgeCase edge_with_ends(Choices& c, double one, double other, double level) {
  double inside = std::max(one, other), outside = std::min(one, other);
  if (inside < level) inside = level;
  if (outside >= level) outside = std::nextafter(level, -HUGE_VAL);
  if (c.below(12) == 0) outside = -HUGE_VAL;
  const bool first = c.flag();
  return {"an edge", first ? inside : outside, first ? outside : inside, level};
}

// Three values of about one size, which is any.
inline EdgeCase any_edge(Choices& c) {
  const int size = int(c.integer(-980, 980));
  const double one = c.real(size - 12, size + 12), other = c.real(size - 12, size + 12);
  return edge_with_ends(c, one, other, c.flag() ? c.real(size - 12, size + 12) : 0);
}

inline std::vector<InputClass<EdgeCase>> generated_edges() {
  return {
      {"values of every size", 30'000, any_edge},
      {"crossings near the ends of the edge, and at the smallest step from them (C-96)", 30'000,
       [](Choices& c) {
         const double level = c.flag() ? c.real(-4, 4) : 0, length = c.positive(-4, 4);
         const double significand = 1 + double(c.below(9)) / 8;
         const double share = std::ldexp(significand, -int(c.integer(1, 60)));
         const double one = c.near(level + length * share);
         return edge_with_ends(c, one, level - length * (1 - share), level);
       }},
      {"values one rounding step beside the level, and the smallest numbers", 20'000,
       [](Choices& c) {
         const double level =
             c.below(4) == 0 ? c.one_of({0.0, -0.0, 0x1p-1074, -0x1p-1074}) : c.real(-1000, 1000);
         const double one = c.near(level);
         return edge_with_ends(c, one, c.flag() ? c.near(c.near(level)) : c.real(-20, 20), level);
       }}};
}

// ---- layered images (task 14.3) ----

// A few polygons with few distances, which come and go. An id comes only if it is not there, and
// goes with what it came with.
inline EditCase any_edits(Choices& c) {
  EditCase made{"edits", 1 + std::size_t(c.below(3)), {}};
  constexpr int kIds = 5;
  std::array<std::vector<Covered>, kIds> there;
  std::array<bool, kIds> is_there{};
  // -1 is no id: the runner writes it where a pixel has no sample.
  using Ids = std::array<int, kIds>;
  const Ids ids = c.one_of({Ids{0, 1, 2, 3, 4}, Ids{-3, -2, 0, 2, 3},
                            Ids{1'000'000, 1'000'001, 1'000'002, 1'000'003, 1'000'004}});
  const std::uint64_t count = 1 + c.below(12);
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::size_t which = c.below(kIds);
    Edit edit{!is_there[which] && c.below(8) > 0, ids[which], {}};
    if (is_there[which]) {
      edit.covered = there[which];
    } else {
      for (std::size_t pixel = 0; pixel < made.pixels; ++pixel) {
        if (c.below(4) == 0) continue;
        const double distance =
            c.flag() ? double(1 + c.below(3)) : c.near(c.one_of({1.0, 2.0, 0x1p40}));
        edit.covered.push_back({pixel, distance});
      }
      if (edit.covered.size() > 1 && c.flag()) std::swap(edit.covered[0], edit.covered.back());
    }
    is_there[which] = edit.comes;
    there[which] = edit.covered;
    made.edits.push_back(std::move(edit));
  }
  return made;
}

inline std::vector<InputClass<EditCase>> generated_edits() {
  return {{"polygons that come and go, many of them equally near (C-97)", 12'000, any_edits}};
}

// ---- views (task 14.4) ----

// A vector of unit length.
inline Vector unit(const Vector& v) {
  const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  return {v[0] / length, v[1] / length, v[2] / length};
}
// A unit vector that is not near a plane of two axes.
inline Vector any_unit(Choices& c) {
  Vector v{};
  for (double& each : v) {
    const double sign = c.flag() ? -1 : 1;
    each = sign * (0.25 + double(c.below(1 << 20)) * 0x1p-20);
  }
  return unit(v);
}
inline Vector sum_of(const Vector& v, double times, const Vector& w) {
  return {v[0] + times * w[0], v[1] + times * w[1], v[2] + times * w[2]};
}
// Which views see the polygon: most do.
inline std::array<bool, 3> any_sees(Choices& c) {
  std::array<bool, 3> sees{};
  for (bool& each : sees) each = c.below(4) > 0;
  return sees;
}

// The direction as a sum of the views. The weights of two of them may be as small as 2^-4 `least`.
inline Vector direction_from(Choices& c, const std::array<Vector, 3>& views, double least = 1) {
  const std::size_t large = c.below(3);
  Vector v{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double weight = double(1 + c.below(16)) / 16 * (i == large ? 1 : least);
    v = sum_of(v, c.below(3) == 0 ? -weight : weight, views[i]);
  }
  return unit(v);
}

inline double dot_of(const Vector& v, const Vector& w) {
  return v[0] * w[0] + v[1] * w[1] + v[2] * w[2];
}
inline double determinant_of(const Vector& a, const Vector& b, const Vector& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}
// Whether rounding may decide if a weight is 0, or which of two views is nearer to the direction. A
// weight is det(v, d, e) / det(views) with two views d and e, and has an error of at most 64 u /
// |det(views)|; a dot product has one of at most 4 u. Both have room for 2^5 times as much, so that
// the rounding of this function does not matter.
inline bool is_undecided(const ViewCase& input) {
  const auto& [a, b, c] = input.views;
  const Vector& v = input.direction;
  const auto is_near_0 = [&](const Vector& d, const Vector& e) {
    return std::abs(determinant_of(v, d, e)) < 0x1p-42;
  };
  const auto are_equal = [&](const Vector& d, const Vector& e) {
    return std::abs(dot_of(v, d) - dot_of(v, e)) < 0x1p-42;
  };
  return is_near_0(b, c) || is_near_0(c, a) || is_near_0(a, b) || are_equal(a, b) ||
         are_equal(b, c) || are_equal(c, a);
}
// Turns the direction a little, if rounding would decide.
inline ViewCase decided(ViewCase made) {
  for (int i = 0; i < 8 && is_undecided(made); ++i)
    made.direction =
        unit(sum_of(sum_of(made.direction, 0x1p-9, made.views[0]), 0x1p-11, made.views[1]));
  if (!is_undecided(made)) return made;
  return {"views", along(1, 2, 9, 9.2736184954957037), three_views(), made.sees};
}

// Three views that are apart.
inline std::array<Vector, 3> any_views(Choices& c) {
  std::array<Vector, 3> views{};
  views[0] = any_unit(c);
  // The other two are vectors at right angles to the first one and to each other, plus a multiple
  // of the first one.
  const Vector& a = views[0];
  views[1] = unit(sum_of({a[1], -a[0], 0}, double(c.integer(-8, 8)) / 8, a));
  const Vector third{a[0] * a[2], a[1] * a[2], -(a[0] * a[0] + a[1] * a[1])};
  views[2] = unit(sum_of(unit(third), double(c.integer(-8, 8)) / 8, a));
  if (c.flag()) std::swap(views[0], views[2]);
  if (c.flag()) std::swap(views[0], views[1]);
  return views;
}
// A sum of weights may be as small as 2^-36.
inline ViewCase views_apart(Choices& c) {
  const std::array<Vector, 3> views = any_views(c);
  const double least = c.flag() ? std::ldexp(1.0, -int(c.below(33))) : 1;
  const Vector direction = direction_from(c, views, least);
  return decided({"views", direction, views, any_sees(c)});
}

// Three views that are nearly in one plane, or nearly the same one, at every power of two.
inline ViewCase views_nearly_flat(Choices& c) {
  std::array<Vector, 3> views = any_views(c);
  const double off = std::ldexp(1.0, -int(c.integer(1, 24)));
  const Vector first = views[0], second = views[1], third = views[2];
  views[2] = unit(sum_of(sum_of(first, 0.75, second), off, third));
  if (c.below(3) == 0) views[1] = unit(sum_of(first, 0.25, second));
  const Vector direction = direction_from(c, views);
  return decided({"views", direction, views, any_sees(c)});
}

// Views along axes, in any order and of any sign. The weights are coordinates of the direction with
// a sign, and nothing is rounded: weights of exactly 0, equally near views.
inline ViewCase views_along_axes(Choices& c) {
  ViewCase made{"views"};
  const std::size_t turn = c.below(3);
  const bool swaps = c.flag();
  for (std::size_t i = 0; i < 3; ++i) made.views[i][(i + turn) % 3] = c.flag() ? -1 : 1;
  if (swaps) std::swap(made.views[0], made.views[1]);
  Vector v{};
  for (double& each : v) each = double(c.integer(-2, 2));
  if (v[0] == 0 && v[1] == 0 && v[2] == 0) v[c.below(3)] = c.flag() ? -1 : 1;
  made.direction = unit(v);
  for (bool& sees : made.sees) sees = c.flag();
  return made;
}

inline std::vector<InputClass<ViewCase>> generated_views_around() {
  return {{"views that are apart", 6'000, views_apart},
          {"views that are nearly in one plane", 6'000, views_nearly_flat},
          {"views along axes: weights of 0, and views that are equally near (C-98)", 6'000,
           views_along_axes}};
}

// ---- bands (tasks 14.5, 14.6) ----

inline BandCase any_bands(Choices& c) {
  BandCase made{"pixels", {}, 0};
  const std::size_t bands = 1 + c.below(5), count = 1 + c.below(12);
  const double offset = c.flag() ? 0 : c.real(0, 40);
  const int lowest = int(c.integer(-10, 6));
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<double> pixel;
    for (std::size_t b = 0; b < bands; ++b)
      pixel.push_back(offset + std::ldexp(double(c.integer(-1000, 1000)), lowest));
    made.pixels.push_back(std::move(pixel));
  }
  return made;
}

// Pixels in pairs on both sides of a mean, along the rows of a matrix of vectors at right angles:
// these are the eigenvectors of the covariance. Later rows have shorter pairs.
inline BandCase pairs_of_pixels(Choices& c) {
  BandCase made{"pixels", {}, 0};
  const std::size_t bands = 1 + c.below(5);
  // The reflection I - 2 v v^T / |v|^2, whose rows are unit vectors at right angles, with its first
  // row last: it is not symmetric, so that its columns are other vectors.
  std::vector<double> v;
  double square = 0;
  for (std::size_t i = 0; i < bands; ++i) {
    v.push_back(double(1 + c.below(4)));
    square += v.back() * v.back();
  }
  for (std::size_t i = 0; i < bands; ++i) {
    std::vector<double> row;
    for (std::size_t j = 0; j < bands; ++j) row.push_back((i == j) - 2 * v[i] * v[j] / square);
    made.vectors.push_back(std::move(row));
  }
  std::rotate(made.vectors.begin(), made.vectors.begin() + 1, made.vectors.end());
  const double offset = c.flag() ? 0 : c.real(0, 30);
  for (std::size_t i = 0; i < bands; ++i) made.mean.push_back(offset + double(c.below(10)));
  double size = double(1 + c.below(1000));
  for (const std::vector<double>& row : made.vectors) {
    std::vector<double> before = made.mean, after = made.mean;
    for (std::size_t j = 0; j < bands; ++j) {
      before[j] -= size * row[j];
      after[j] += size * row[j];
    }
    made.pixels.push_back(std::move(before));
    made.pixels.push_back(std::move(after));
    size *= double(c.below(8)) / 8;
  }
  made.k = c.below(bands + 1);
  return made;
}

inline std::vector<InputClass<BandCase>> generated_bands() {
  return {{"up to twelve pixels of up to five bands", 15'000, any_bands}};
}
inline std::vector<InputClass<BandCase>> generated_components() {
  return {
      {"pixels in pairs along the vectors, and any number of components", 12'000, pairs_of_pixels}};
}

}  // namespace inputs
}  // namespace lab_14
