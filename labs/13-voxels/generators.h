// The generated inputs of lab 13: for each function inputs of all kinds that student.h names, and
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

namespace lab_13 {
// A namespace of its own: a function or type of yours in student.cpp may have the name of one of
// these, and does not replace it.
inline namespace inputs {

using glassbox::labs::Choices;
using glassbox::labs::InputClass;

// ---- cameras around a box (task 13.1) ----

// Along one axis: two ends of a box, and positions that are on them, one rounding step beside them,
// between them or anywhere.
struct AxisChoices {
  double low, high;
  int side;  // where most positions are: 0 anywhere, 1 below the box, 2 above it, 3 in it
};
inline AxisChoices any_axis(Choices& c, int lowest, int highest) {
  const double one = c.below(8) == 0 ? 0 : c.real(lowest, highest);
  const double other = c.below(8) == 0 ? one : c.real(lowest, highest);
  return {std::min(one, other), std::max(one, other), int(c.below(4))};
}
inline double any_coordinate(Choices& c, const AxisChoices& axis, int lowest, int highest) {
  const int side = c.below(12) == 0 ? 0 : axis.side;
  const double size = c.positive(lowest, highest);
  switch (side) {
    case 1:
      return c.flag() ? axis.low - size : std::nextafter(axis.low, -HUGE_VAL);
    case 2:
      return c.flag() ? axis.high + size : std::nextafter(axis.high, HUGE_VAL);
    case 3:
      return c.one_of({axis.low, axis.high, axis.low / 2 + axis.high / 2});
    default:
      return c.near(c.one_of({axis.low, axis.high, size, -size}));
  }
}
inline OrderCase any_order(Choices& c, int lowest, int highest) {
  std::array<AxisChoices, 3> axes{};
  for (AxisChoices& axis : axes) axis = any_axis(c, lowest, highest);
  OrderCase made{
      "cameras",
      {},
      {{axes[0].low, axes[1].low, axes[2].low}, {axes[0].high, axes[1].high, axes[2].high}}};
  for (std::uint64_t i = 1 + c.below(4); i > 0; --i) {
    const double x = any_coordinate(c, axes[0], lowest, highest);
    const double y = any_coordinate(c, axes[1], lowest, highest);
    made.cameras.push_back({x, y, any_coordinate(c, axes[2], lowest, highest)});
  }
  return made;
}

inline std::vector<InputClass<OrderCase>> generated_orders() {
  return {{"cameras on faces, one rounding step beside them, and around the box", 25'000,
           [](Choices& c) { return any_order(c, 0, 3); }},
          {"boxes and cameras of any size", 15'000,
           [](Choices& c) { return any_order(c, -1000, 1000); }}};
}

// ---- colours (task 13.2) ----

inline double any_level(Choices& c) {
  switch (c.below(3)) {
    case 0:
      return double(c.below(256));
    case 1:
      return c.one_of({0.0, 255.0, 1e-150});
    default:
      return c.positive(-30, 6);
  }
}
// A colour like another one, each channel a little more or less, but from 0 to 255.
inline Colour colour_beside(Choices& c, Colour colour, int lowest) {
  for (double& value : colour) {
    const double step = std::ldexp(double(c.integer(-16, 16)), lowest);
    value = std::clamp(value + step, 0.0, 255.0);
  }
  return colour;
}
inline Colour any_colour(Choices& c) {
  Colour colour{};
  for (double& value : colour) value = any_level(c);
  return colour;
}
inline ColoursCase any_colours(Choices& c, std::uint64_t most) {
  ColoursCase made{"colours", {}};
  for (std::uint64_t i = c.below(most + 1); i > 0; --i) made.colours.push_back(any_colour(c));
  return made;
}
inline ColoursCase near_colours(Choices& c, std::uint64_t most) {
  ColoursCase made{"colours", {}};
  const Colour first = any_colour(c);
  const int lowest = int(c.integer(-44, 2));
  for (std::uint64_t i = 1 + c.below(most); i > 0; --i)
    made.colours.push_back(colour_beside(c, first, lowest));
  return made;
}

inline std::vector<InputClass<ColoursCase>> generated_colours() {
  return {{"up to twelve colours", 15'000, [](Choices& c) { return any_colours(c, 12); }},
          {"up to twelve colours, almost equal (C-93)", 20'000,
           [](Choices& c) { return near_colours(c, 12); }},
          {"colours that are all equal", 5'000,
           [](Choices& c) {
             const Colour colour = any_colour(c);
             return ColoursCase{"colours", std::vector<Colour>(1 + c.below(20), colour)};
           }},
          {"many colours", 60,
           [](Choices& c) { return c.flag() ? near_colours(c, 3000) : any_colours(c, 3000); }}};
}

// ---- verdicts (task 13.3) ----

// The colours are whole multiples of a step that is a power of two, and k2 is an odd multiple of a
// 64th of it, so that the deviation is never exactly T. That it is within 2^-40 of T happens in one
// run of some three million.
inline Pixel any_pixel(Choices& c, const Colour& colour, double step, int reach) {
  Pixel pixel{colour, false, false};
  for (double& value : pixel.colour)
    value = std::clamp(value + step * double(c.integer(-reach, reach)), 0.0, 255.0);
  pixel.is_background = c.below(6) == 0;
  pixel.is_hidden = c.below(5) == 0;
  return pixel;
}
inline JudgeCase any_judged(Choices& c) {
  const double step = std::ldexp(1.0, -int(c.below(9)));
  const int reach = int(c.below(40));
  JudgeCase made{"a voxel", {}, {double(c.below(9)) / 4, 0}};
  made.threshold.k2 = step * double(2 * c.below(32 * std::uint64_t(reach) + 1) + 1) / 64;
  if (c.below(16) == 0) made.threshold.k2 = INFINITY;
  Colour colour{};
  for (double& value : colour) value = double(c.below(256));
  const std::uint64_t views = c.below(5);
  for (std::uint64_t i = 0; i < views; ++i) {
    made.pictures.emplace_back();
    for (std::uint64_t k = c.below(3); k > 0; --k)
      made.pictures.back().push_back(any_pixel(c, colour, step, reach));
  }
  return made;
}

// A deviation 2^-30 above or below T, which depends on M. In each of two pictures there is black
// and the colour m (2, 2, 4), which have the deviation 2 m (see below), and all four pixels
// together have the deviation sqrt(8/3) m.
inline JudgeCase beside_threshold(Choices& c) {
  const double m = c.positive(0, 4), k1 = double(c.below(7)) / 8;
  JudgeCase made{"a voxel", {}, {k1, std::sqrt(8.0 / 3) * m - k1 * 2 * m}};
  Pixel other = grey(0);
  other.colour = {2 * m, 2 * m, 4 * m};
  made.pictures.assign(2, {grey(0), other});
  made.threshold.k2 += c.flag() ? 0x1p-30 : -0x1p-30;
  return made;
}

// A deviation of exactly T, or 2^-36 beside it. Two colours that differ by m (2, 2, 4) have the
// deviation 2 m, and (0, 0, 3 m) in one channel of three colours has the deviation m: no number is
// rounded on the way.
inline JudgeCase exactly_threshold(Choices& c) {
  JudgeCase made{"a voxel", {}, {double(c.below(3)), 0}};
  const double m = double(c.below(33)), level = double(c.below(100));
  const Pixel base = grey(level);
  std::vector<Pixel> seen{base};
  if (c.flag()) {
    Pixel other = base;
    other.colour = {level + 2 * m, level + 2 * m, level + 4 * m};
    seen.push_back(other);
    made.threshold.k2 = 2 * m;
  } else {
    Pixel other = base;
    other.colour[c.below(3)] += 3 * m;
    seen.push_back(base);
    seen.push_back(other);
    made.threshold.k2 = m;
  }
  made.threshold.k2 += c.one_of({0.0, 0x1p-36, -0x1p-36});
  for (const Pixel& pixel : seen) {
    made.pictures.push_back({pixel});
    if (c.below(4) == 0) made.pictures.back().push_back(hidden_grey(double(c.below(256))));
    if (c.below(4) == 0) made.pictures.back().push_back(background());
    if (c.below(4) == 0) made.pictures.emplace_back();
  }
  return made;
}

inline std::vector<InputClass<JudgeCase>> generated_judged() {
  return {{"pictures with background and hidden pixels", 40'000, any_judged},
          {"a deviation of exactly T, and 2^-36 beside it", 20'000, exactly_threshold},
          {"a deviation 2^-30 beside T, which depends on M", 20'000, beside_threshold}};
}

// ---- footprints (task 13.4) ----

// Parallel projections of few digits: nothing is rounded, and many corners are at pixel centres,
// at borders of pixels and at the border of the picture.
inline FootprintCase parallel_footprint(Choices& c) {
  FootprintCase made{"a voxel", {}, {}, 1 + int(c.below(8)), 1 + int(c.below(6))};
  const double sign = c.below(16) == 0 ? -1 : 1;
  const double w = std::ldexp(sign, int(c.integer(-3, 3)));
  for (std::size_t i = 0; i < 2; ++i) {
    for (double& entry : made.pixel_from_grid[i]) {
      const auto whole = double(c.integer(-8, 8));
      entry = whole / double(c.one_of({1, 2, 4})) * w;
    }
  }
  made.pixel_from_grid[2] = {0, 0, 0, w};
  const int x = int(c.integer(-3, 3)), y = int(c.integer(-3, 3));
  made.voxel = {x, y, int(c.integer(-3, 3))};
  return made;
}

// The same, for a voxel that is larger than every int, or so far away. A position is a multiple of
// 1/2 below 2^52: three products of an entry of at most 2^37 and a coordinate of at most 2^13 + 1,
// and another entry.
inline FootprintCase large_footprint(Choices& c) {
  FootprintCase made = parallel_footprint(c);
  made.pixel_from_grid[2][3] = 1;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      const auto factor = double(c.integer(-2, 2));
      made.pixel_from_grid[i][k] = std::ldexp(factor, int(c.integer(0, 36)));
    }
  }
  made.voxel = {0, 0, 0};
  if (c.flag()) made.voxel = {int(c.sized(13)), int(c.sized(13)), int(c.sized(13))};
  return made;
}

// A small voxel whose centre is exactly on the border of a pixel, or of the picture. Nothing is
// rounded.
inline FootprintCase footprint_on_border(Choices& c) {
  FootprintCase made = parallel_footprint(c);
  const double w = made.pixel_from_grid[2][3];
  const double centre[3] = {made.voxel.x + 0.5, made.voxel.y + 0.5, made.voxel.z + 0.5};
  for (std::size_t i = 0; i < 2; ++i) {
    std::array<double, 4>& row = made.pixel_from_grid[i];
    row[3] = double(c.integer(-1, 8)) * w;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto sign = double(c.integer(-1, 1));
      row[k] = std::ldexp(sign * w, -int(c.integer(1, 4)));
      row[3] -= row[k] * centre[k];
    }
  }
  return made;
}

// A voxel so far from the grid's first one that float does not have its number. Nothing is rounded
// in double.
inline FootprintCase distant_footprint(Choices& c) {
  FootprintCase made = parallel_footprint(c);
  const int x = int(c.sized(30)), y = int(c.sized(30));
  made.voxel = {x, y, int(c.sized(30))};
  made.pixel_from_grid[2][3] = 1;
  for (std::size_t i = 0; i < 2; ++i) {
    std::array<double, 4>& row = made.pixel_from_grid[i];
    for (std::size_t k = 0; k < 3; ++k) row[k] = double(c.integer(-2, 2));
    row[3] = double(c.integer(-1, 8)) -
             (row[0] * made.voxel.x + row[1] * made.voxel.y + row[2] * made.voxel.z);
  }
  return made;
}

// The homogeneous position of a point; exact for numbers of few digits.
inline Colour times(const Projection& p, double x, double y, double z) {
  Colour h{};
  for (std::size_t i = 0; i < 3; ++i) h[i] = p[i][0] * x + p[i][1] * y + p[i][2] * z + p[i][3];
  return h;
}

// How far a number is from the nearest half of a whole number.
inline double half_distance(double at) {
  return std::abs(2 * at - std::floor(2 * at + 0.5)) / 2;
}
// Whether the voxel's centre or a corner is so near to the middle or the border of a pixel that
// rounding decides on which side it is.
inline bool is_undecided(const FootprintCase& input) {
  for (int i = 0; i < 9; ++i) {
    const double half = i == 8 ? 0.5 : 0;
    const auto h = times(input.pixel_from_grid, input.voxel.x + (i & 1) + half,
                         input.voxel.y + (i >> 1 & 1) + half, input.voxel.z + (i >> 2 & 1) + half);
    if (h[2] <= 0) continue;
    if (half_distance(h[0] / h[2]) < 0x1p-19 || half_distance(h[1] / h[2]) < 0x1p-19) return true;
  }
  return false;
}

// A turned camera of few digits at any distance from the voxel, which may be in front of it, partly
// behind it or wholly.
inline FootprintCase turned_footprint(Choices& c) {
  FootprintCase made{"a voxel", {}, {}, 1 + int(c.below(12)), 1 + int(c.below(9))};
  const int x = int(c.integer(-20, 20)), y = int(c.integer(-20, 20));
  made.voxel = {x, y, int(c.integer(-20, 20))};
  Projection& p = made.pixel_from_grid;
  for (auto& row : p) {
    for (std::size_t k = 0; k < 3; ++k) row[k] = double(c.integer(-8, 8)) / 8;
  }
  // The numbers of the row of w have few digits, so that its sign is exact: w at the voxel's first
  // corner is a distance of a few sixteenths, or of up to 2^12.
  const double w = c.flag() ? double(c.integer(-16, 48)) / 16 : double(c.integer(1, 1 << 12));
  for (std::size_t i = 0; i < 3; ++i)
    p[i][3] = -(p[i][0] * made.voxel.x + p[i][1] * made.voxel.y + p[i][2] * made.voxel.z);
  p[2][3] += w;
  // In a short focal length a voxel looks lopsided: a rectangle may have pixels, but not the one of
  // the voxel's centre.
  const double focal = std::ldexp(1.0, int(c.integer(0, c.flag() ? 12 : 1)));
  const double column = double(c.integer(-2 * 1024, 15 * 1024 - 1)) / 1024;
  const double row = double(c.integer(-2 * 1024, 12 * 1024 - 1)) / 1024;
  for (std::size_t k = 0; k < 4; ++k) {
    p[0][k] = focal * p[0][k] + column * p[2][k];
    p[1][k] = focal * p[1][k] + row * p[2][k];
  }
  // Where rounding would decide, the picture is moved by a part of a pixel.
  for (int i = 0; i < 40 && is_undecided(made); ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      p[0][k] += 0x1p-9 * p[2][k];
      p[1][k] += 0x1p-8 * p[2][k];
    }
  }
  if (is_undecided(made)) made.pixel_from_grid = along_z(48, 3.1, 2.2, 12.3);
  return made;
}

// The same in a wide picture, so that a position in float is wrong by many 2^-20 px: a corner is
// 2^-17 px beside the centre of a pixel.
inline FootprintCase footprint_in_wide_picture(Choices& c) {
  const FootprintCase narrow = turned_footprint(c);
  FootprintCase made = narrow;
  made.width = 4096;
  const auto corner = c.below(8);
  const auto h = times(made.pixel_from_grid, made.voxel.x + double(corner & 1),
                       made.voxel.y + double(corner >> 1 & 1), made.voxel.z + double(corner >> 2));
  const double off = c.flag() ? 0x1p-17 : -0x1p-17;
  const double place = double(c.integer(1024, 4000)) + 0.5 + off;
  const double shift = place - h[0] / h[2];
  if (!(h[2] > 0) || std::abs(shift) > 0x1p13) return narrow;
  for (std::size_t k = 0; k < 4; ++k)
    made.pixel_from_grid[0][k] += shift * made.pixel_from_grid[2][k];
  return is_undecided(made) ? narrow : made;
}

inline std::vector<InputClass<FootprintCase>> generated_footprints() {
  return {{"numbers of few digits, with corners on pixel centres", 20'000, parallel_footprint},
          {"turned cameras at every distance (C-87)", 20'000, turned_footprint},
          {"borders near the centre of a pixel in wide pictures", 300, footprint_in_wide_picture},
          {"small voxels whose centre is on the border of a pixel", 10'000, footprint_on_border},
          {"voxels whose numbers are too large for float", 5'000, distant_footprint},
          {"voxels larger than every picture", 5'000, large_footprint}};
}

// ---- sweeps (task 13.5) ----

// A camera of few digits. In a parallel projection nothing is rounded; in a perspective one the
// place of a voxel's centre is a quotient of small numbers: a whole number, or far from one.
inline Picture any_picture(Choices& c, int width, int height) {
  Picture picture{{}, width, height, {}};
  auto& p = picture.pixel_from_grid;
  const bool is_parallel = c.flag();
  for (std::size_t i = 0; i < 2; ++i) {
    for (double& entry : p[i]) entry = double(c.integer(-4, 4)) / 2;
  }
  p[2] = {0, 0, 0, 1};
  if (is_parallel) {  // many centres are on the border of a pixel, or beside it
    for (std::size_t i = 0; i < 2; ++i) p[i][3] += c.one_of({0.0, 0x1p-30, -0x1p-30});
  } else {
    for (double& entry : p[2]) entry = double(c.integer(-2, 2)) / 2;
  }
  const auto size = std::size_t(width) * std::size_t(height);
  const Colour colours[] = {kRed, kBlue, {200, 31, 21}};
  for (std::size_t i = 0; i < size; ++i) {
    Pixel pixel;
    pixel.colour = colours[c.below(3)];
    pixel.is_background = c.below(8) == 0;
    picture.pixels.push_back(pixel);
  }
  return picture;
}

inline SweepCase any_sweep(Choices& c) {
  SweepCase made{"a grid", {}, {}, {double(c.below(3)), 0}};
  for (int& count : made.grid.count) count = 1 + int(c.below(3));
  made.grid.axis = int(c.below(3));
  made.grid.away = c.flag() ? -1 : 1;
  // Red is 0.8 from the third colour and more than 100 from blue.
  made.threshold.k2 = c.one_of({2.0, 0.25, HUGE_VAL, 0.0});
  const std::uint64_t views = 1 + c.below(4);
  for (std::uint64_t i = 0; i < views; ++i) {
    const int width = 1 + int(c.below(5));
    made.pictures.push_back(any_picture(c, width, 1 + int(c.below(4))));
  }
  return made;
}

// The cameras of a real sweep: pictures side by side, layers along any axis.
inline SweepCase flat_sweep(Choices& c) {
  std::vector<Solid> solids;
  for (std::uint64_t i = c.below(8); i > 0; --i) {
    const int x = int(c.below(8)), y = int(c.below(3)), z = int(c.below(5));
    solids.push_back({{x, y, z}, c.flag() ? kRed : kBlue});
  }
  SweepCase made{"a grid", flat_pictures(solids, {-1, 0, 1}), kGrid, {0, 2}};
  for (Picture& picture : made.pictures) {
    for (Pixel& pixel : picture.pixels) {
      if (pixel.is_background) continue;
      for (double& value : pixel.colour) value += double(c.below(3)) / 4;
    }
  }
  return made;
}

inline std::vector<InputClass<SweepCase>> generated_sweeps() {
  return {{"small grids, in layers along every axis, with any pictures", 8'000, any_sweep},
          {"coloured voxels in three pictures", 500, flat_sweep}};
}

}  // namespace inputs
}  // namespace lab_13
