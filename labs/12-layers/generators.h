// The generated inputs of lab 12: for each function inputs of all kinds that student.h names, and
// of the borders between them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "cases.h"
#include "labs/framework/choices.h"

namespace lab_12 {
// A namespace of its own: a function or type of yours in student.cpp may have the name of one of
// these, and does not replace it.
inline namespace inputs {

using glassbox::labs::Choices;
using glassbox::labs::InputClass;

// ---- samples to pack (task 12.1) ----

// A depth of any size: 0 < depth <= 1.
inline float any_depth(Choices& c) {
  if (c.below(8) == 0) return c.one_of({1.0f, 0x1p-149f, 0x1p-126f});
  return float(c.positive(c.flag() ? -8 : -140, -1));
}

// Depths and an epsilon of few digits: many depths are equal, or exactly epsilon z apart.
inline PackCase pack_few_depths(Choices& c) {
  const int width = 1 + int(c.below(3)), height = 1 + int(c.below(3));
  PackCase made{"a picture", width, height, {}, double(c.below(9)) / 16};
  const auto count = c.below(9);
  for (std::uint64_t i = 0; i < count; ++i) {
    const int x = int(c.below(std::uint64_t(width))), y = int(c.below(std::uint64_t(height)));
    made.samples.push_back({x, y, float(1 + c.below(16)) / 16, {}});
  }
  made.samples = numbered(made.samples);
  return made;
}

// Samples of one pixel, of which the second is epsilon z behind the first: exactly, as far as a
// double can say it, or one rounding step more or less.
inline PackCase pack_at_epsilon(Choices& c) {
  const float front = any_depth(c), behind = std::min(front, any_depth(c));
  const double epsilon = c.near((double(front) - double(behind)) / double(front));
  PackCase made{"two depths", 1, 1, {{0, 0, front, {}}, {0, 0, behind, {}}}, std::abs(epsilon)};
  if (c.flag()) made.samples.push_back({0, 0, c.near(behind), {}});
  for (Sample& s : made.samples) s.depth = std::clamp(s.depth, 0x1p-149f, 1.0f);
  if (c.flag()) std::swap(made.samples[0], made.samples[1]);
  made.samples = numbered(made.samples);
  return made;
}

// A chain of samples in any order, each of which is near to the one before it, or nearly.
inline PackCase pack_chain(Choices& c) {
  const int bits = 1 + int(c.below(20));
  PackCase made{"a chain", 1, 2, {}, std::ldexp(1.0, -bits)};
  const auto count = 2 + c.below(14);
  double depth = double(any_depth(c));
  for (std::uint64_t i = 0; i < count; ++i) {
    made.samples.push_back({0, int(c.below(8) == 0), float(std::max(depth, 0x1p-149)), {}});
    depth *= 1 - made.epsilon * double(c.below(9)) / 8;
  }
  for (std::size_t i = 1; i < made.samples.size(); ++i)
    std::swap(made.samples[i], made.samples[i - c.below(i + 1)]);
  made.samples = numbered(made.samples);
  return made;
}

// So many samples in one pixel, with so few depths, that a sort which is not stable changes the
// order of equal ones.
inline PackCase pack_many_equal(Choices& c) {
  PackCase made{"many equal depths", 1, 1, {}, c.one_of({0.0, 1.0 / 16})};
  const auto count = 17 + c.below(44);
  for (std::uint64_t i = 0; i < count; ++i)
    made.samples.push_back({0, 0, float(1 + c.below(16)) / 16, {}});
  made.samples = numbered(made.samples);
  return made;
}

inline std::vector<InputClass<PackCase>> generated_packs() {
  return {{"few depths, many of them equal or exactly epsilon apart", 12'000, pack_few_depths},
          {"depths of any size that are epsilon apart, or one step beside that", 12'000,
           pack_at_epsilon},
          {"chains of near samples (C-84)", 6'000, pack_chain},
          {"17 to 60 samples in one pixel, many of them equal", 500, pack_many_equal}};
}

// ---- two eyes (task 12.2) ----

inline Transform<Screen, World> any_camera(Choices& c, int far, int lowest_near) {
  const double focal = double(c.integer(50, 2000));
  const double width = double(c.integer(1, 4000)), height = double(c.integer(1, 4000));
  const double near = c.positive(lowest_near, 0);
  const double x = c.flag() ? c.real(-8, far) : 0, y = c.flag() ? c.real(-8, far) : 0;
  const double z = c.flag() ? c.real(-8, far) : 0;
  return camera(focal, width, height, near, x, y, z, c.multiple(-2, 2, 64));
}

inline std::vector<InputClass<MatrixCase>> generated_matrices() {
  return {
      {"two eyes of any kind", 400,
       [](Choices& c) {
         const auto first = any_camera(c, 3, -4);
         return MatrixCase{"two eyes", first, any_camera(c, 3, -4)};
       }},
      {"far from the origin, and with near planes down to a millionth (C-37)", 200, [](Choices& c) {
         const auto first = any_camera(c, 12, -20);
         return MatrixCase{"two eyes", first, any_camera(c, 12, -20)};
       }}};
}

// ---- rows (task 12.3) ----

// A depth whose product with an entry of the warp does not underflow.
inline float row_depth(Choices& c) {
  return c.below(8) == 0 ? 1.0f : float(c.positive(c.flag() ? -8 : -64, -1));
}

inline Transform<Screen, Screen> any_warp(Choices& c, int lowest, int highest) {
  Transform<Screen, Screen> m;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) m.at(i, j) = c.below(4) == 0 ? 0 : c.real(lowest, highest);
  }
  return m;
}

inline RowCase short_row(Choices& c) {
  RowCase made{"a row", any_warp(c, -8, 8), int(std::abs(c.sized(14))), {}};
  made.depths.resize(c.below(9));
  for (auto& here : made.depths) {
    for (std::uint64_t i = c.below(4); i > 0; --i) here.push_back(row_depth(c));
  }
  return made;
}

// A long row with samples in a few pixels, among them the last one. The first column of the warp is
// small, as it is where the row is about as long in the second picture.
inline RowCase long_row(Choices& c) {
  RowCase made{"a row", row_matrix(8192), int(std::abs(c.sized(14))), {}};
  for (int i = 0; i < 4; ++i) {
    made.warp.at(i, 0) = c.real(-6, 0);
    made.warp.at(i, 3) = c.flag() ? c.real(0, 12) : 0;
  }
  const std::size_t length = 1 + c.below(16'384);
  made.depths.resize(length);
  made.depths.back() = {row_depth(c)};
  for (std::uint64_t i = c.below(30); i > 0; --i) {
    const std::size_t x = c.below(length);
    made.depths[x].push_back(row_depth(c));
  }
  return made;
}

inline std::vector<InputClass<RowCase>> generated_rows() {
  return {{"short rows with any warp", 15'000, short_row},
          {"long rows with samples in a few pixels (C-80)", 150, long_row}};
}

// ---- sizes (task 12.4) ----

inline double any_cosine(Choices& c) {
  switch (c.below(4)) {
    case 0:
      return double(c.below(65)) / 64;
    case 1:
      return c.one_of({0.0, 1.0, 0x1p-149});
    default:
      return c.positive(c.flag() ? -5 : -149, -1);
  }
}

// Exactly 1 px or 64 px, or less than a thousandth beside. Squares of powers of two are under the
// root, and powers of two before it: nothing is rounded.
inline SizeCase size_at_limit(Choices& c) {
  const int root = int(c.integer(-6, 6)), power = int(c.integer(-20, 20));
  const int size = c.flag() ? 6 : 0;
  const double most = std::ldexp(1.0, std::min(0, 2 * root));
  const auto off = double(c.integer(-2, 2));
  const double beside = 1 + off * std::ldexp(1.0, -int(c.integer(11, 45)));
  const double w = std::ldexp(1.0, power + root - size) * beside;
  return {"a sample", std::ldexp(1.0, power), w, std::ldexp(most, -2 * root), most};
}

inline SizeCase any_size(Choices& c, int lowest, int highest_ratio, int lowest_w, int highest_w) {
  const double ratio = c.positive(lowest, highest_ratio);
  const double w = c.positive(lowest_w, highest_w);
  const double first = any_cosine(c);
  return {"a sample", ratio, w, first, any_cosine(c)};
}

inline std::vector<InputClass<SizeCase>> generated_sizes() {
  return {{"sizes of every kind", 30'000, [](Choices& c) { return any_size(c, -4, 4, -8, 4); }},
          {"the smallest and the largest numbers", 20'000,
           [](Choices& c) { return any_size(c, -149, 127, -149, 127); }},
          {"1 px or 64 px, and less than a thousandth beside", 20'000, size_at_limit}};
}

// ---- orders (task 12.5) ----

// An epipole at the centre of a column or at its border, as nearly as a double can say it, or one
// step beside; 0 has no such step that the contract allows.
inline OrderCase epipole_at_column(Choices& c) {
  const double w = c.flag() ? c.real(-890, 890) : c.real(-3, 3);
  const int count = 1 + int(c.below(12));
  const double at = double(c.integer(-2, 2 * count + 2)) / 2 * w;
  return {"an epipole", at == 0 ? 0 : c.near(at), w, count};
}

// A row that is long enough for (i + 1/2) w to need 65 bits or more at its end. This product is a
// multiple of 2^13, which is the epipole, and 1 more or less: numbers of 64 bits, the long double
// of some machines, take it for the epipole. n is 2 i + 1, so that n `inverse` is 1 modulo 2^13.
inline OrderCase epipole_near_long_product(Choices& c) {
  const std::uint64_t i = 2048 + c.below(64), n = 2 * i + 1;
  std::uint64_t inverse = n;  // right to 3 bits, and to twice as many after each step
  for (int step = 0; step < 3; ++step) inverse *= 2 - n * inverse;
  if (c.flag()) inverse = -inverse;
  const std::uint64_t high = (std::uint64_t(1) << 39) + c.below(std::uint64_t(1) << 39);
  double w = double(high << 13 | (inverse & 0x1fff));
  w = std::ldexp(w, int(c.integer(-60, -48)));
  if (c.flag()) w = -w;
  return {"an epipole", (double(i) + 0.5) * w, w, int(i + 1 + c.below(2))};
}

inline std::vector<InputClass<OrderCase>> generated_orders() {
  return {
      {"epipoles in and beside the picture, before and behind the eye (C-82)", 30'000,
       [](Choices& c) {
         const double w = double(c.integer(-6, 6)) / 4, at = double(c.integer(-24, 24)) / 8;
         return OrderCase{"an epipole", w == 0 && at == 0 ? 1 : at, w, int(c.below(13))};
       }},
      {"epipoles of any size", 20'000,
       [](Choices& c) {
         const double w = c.below(8) == 0 ? c.one_of({0.0, -0.0}) : c.real(-900, 900);
         return OrderCase{"an epipole", c.real(-900, 900), w, int(c.below(13))};
       }},
      {"epipoles at a column's centre or border, or one rounding step beside it", 40'000,
       epipole_at_column},
      {"long rows", 40,
       [](Choices& c) {
         const double w = c.real(-3, 3);
         const int count = 1 + int(c.below(16'384));
         return OrderCase{"an epipole", c.near((double(c.below(std::uint64_t(count))) + 0.5) * w),
                          w, count};
       }},
      {"epipoles that 64 bits do not tell from a column's centre", 200, epipole_near_long_product}};
}

// ---- pictures (task 12.6) ----

inline Canvas any_canvas(Choices& c) {
  Canvas canvas = canvas_of(c.flag() ? Hiding::kLast : Hiding::kNearest, {});
  canvas.width = 1 + int(c.below(8));
  canvas.height = 1 + int(c.below(6));
  return canvas;
}

// Positions, sides and depths of few digits: edges on centres of pixels, equal depths.
inline DrawCase few_digits(Choices& c) {
  Canvas canvas = any_canvas(c);
  const auto count = int(c.below(5));
  for (int i = 0; i < count; ++i) {
    const double x = double(c.integer(-8, 40)) / 4, y = double(c.integer(-8, 32)) / 4;
    const double side = double(c.below(17)) / 4, z = double(c.integer(-1, 9)) / 8;
    double w = std::ldexp(1.0, int(c.flag() ? c.integer(-135, 120) : c.integer(-2, 2)));
    if (c.below(8) == 0) w = -w;
    canvas.samples.push_back(placed(x, y, z, w, side, i + 1));
    if (c.below(16) == 0) canvas.samples.back().at.w = 0;
  }
  return {"a picture", canvas};
}

// How far a centre of a pixel is from a position.
inline double centre_distance(double at) {
  const double from_centre = at - 0.5;
  return std::abs(from_centre - std::floor(from_centre + 0.5));
}

// One sample in a wide picture, so that a position in float is wrong by many 2^-20 px. The right
// edge of its square is 2^-17 px from the centre of a pixel.
inline DrawCase near_centre(Choices& c, int width) {
  Canvas canvas = canvas_of(c.flag() ? Hiding::kLast : Hiding::kNearest, {}, width, 1);
  Placed sample;
  const double w = c.positive(-20, 20);
  sample.at = {float(double(c.below(std::uint64_t(width))) * w), float(0.75 * w), float(w / 2),
               float(w)};
  sample.colour = number_colour(1);
  const double x = double(sample.at.x) / double(sample.at.w);
  const double off = c.flag() ? 0x1p-17 : -0x1p-17;
  const std::uint64_t farthest = c.flag() ? 3 : std::uint64_t(width);
  sample.side = 2 * (std::floor(x) + 1.5 + double(c.below(farthest)) + off - x);
  const double y = double(sample.at.y) / double(sample.at.w);
  const auto is_near = [&] {
    const double half = sample.side / 2;
    return std::min({centre_distance(x - half), centre_distance(x + half),
                     centre_distance(y - half), centre_distance(y + half)}) < 0x1p-19;
  };
  while (is_near()) sample.side += 0x1p-16;
  canvas.samples = {sample};
  return {"a picture", canvas};
}

// Two samples at nearly the same depth, each of which covers the whole picture, or one on the near
// plane.
inline DrawCase equal_depths(Choices& c) {
  Canvas canvas = canvas_of(c.flag() ? Hiding::kLast : Hiding::kNearest, {}, 1, 1);
  const float w = float(c.positive(-60, 60));
  const float other = c.flag() ? c.near(w) : float(c.positive(-60, 60));
  const float z = c.flag() ? w : float(double(w) * c.positive(-20, -1));
  const double as_far = double(z) / double(w) * double(other);
  canvas.samples = {
      {{0.5f * w, 0.5f * w, c.near(z), w}, 4, number_colour(1)},
      {{0.5f * other, 0.5f * other, c.near(float(as_far)), other}, 4, number_colour(2)}};
  if (c.flag()) std::swap(canvas.samples[0], canvas.samples[1]);
  return {"a picture", canvas};
}

// Samples that are far outside the picture, and squares that are larger than every int.
inline DrawCase far_outside(Choices& c) {
  Canvas canvas = any_canvas(c);
  const auto count = int(1 + c.below(3));
  for (int i = 0; i < count; ++i) {
    Placed sample;
    if (c.flag()) {  // a position of up to 2^127 2^149 pixels
      const float x = float(c.real(100, 127)), w = float(c.positive(-149, 60));
      sample = {{x, c.flag() ? x : -x, 0, w}, std::ldexp(1.0, int(c.below(7))), {}};
    } else {  // a large square with an edge in the picture or at its other side
      const double side = std::ldexp(1.0, int(c.integer(7, 45)));
      double x = 0.25;
      if (!c.flag()) {
        const double sign = c.flag() ? -1 : 1;
        x = std::ldexp(sign, int(c.below(46)));
      }
      sample = placed(x, 0.25, 0.5, 1, side, 0);
    }
    sample.colour = number_colour(i + 1);
    canvas.samples.push_back(sample);
  }
  return {"a picture", canvas};
}

inline std::vector<InputClass<DrawCase>> generated_pictures() {
  return {
      {"positions and sides of few digits, with edges on centres of pixels", 15'000, few_digits},
      {"edges as near to a centre as the contract allows", 4'000,
       [](Choices& c) { return near_centre(c, 1 + int(c.below(12))); }},
      {"the same in wide pictures", 300,
       [](Choices& c) { return near_centre(c, 1 + int(c.below(4000))); }},
      {"depths that are equal, or one rounding step apart, and those at the near plane", 15'000,
       equal_depths},
      {"far outside the picture, and squares larger than it (C-83)", 5'000, far_outside}};
}

}  // namespace inputs
}  // namespace lab_12
