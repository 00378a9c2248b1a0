// The generated inputs of lab 11: of all kinds that student.h names and of the borders between
// them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "cases.h"
#include "labs/framework/choices.h"

namespace lab_11 {
// A namespace of its own: a function or type of yours in student.cpp may have the name of one of
// these, and does not replace it.
inline namespace inputs {

using glassbox::labs::Choices;
using glassbox::labs::InputClass;

// ---- pictures (tasks 11.1 and 11.2) ----

// Grey values of one kind: all of them equal, black and white, three codes beside each other (so
// that many are equal and many differ by one), or any.
inline Picture any_picture(Choices& c, int width, int height) {
  Picture picture{width, height, std::vector<int>(std::size_t(width * height))};
  const std::uint64_t kind = c.below(4);
  const int base = int(c.below(254));
  for (int& grey : picture.grey) {
    grey = kind == 0   ? base
           : kind == 1 ? 255 * int(c.below(2))
           : kind == 2 ? base + int(c.below(3))
                       : int(c.below(256));
  }
  return picture;
}

// A place of the picture, with a disparity up to the left edge, a little beyond it, or far beyond.
inline Place any_place(Choices& c, int width, int height) {
  const int x = int(c.below(std::uint64_t(width))), y = int(c.below(std::uint64_t(height)));
  switch (c.below(4)) {
    case 0:
      return {x, y, int(c.below(std::uint64_t(x) + 1))};
    case 1:
      return {x, y, x};
    case 2:
      return {x, y, x + 1 + int(c.below(3))};
    default:
      return {x, y, c.one_of({0, 1, 255, 65536, 2147483647})};
  }
}

inline SadCase one_square(Choices& c, int largest_side, int radius) {
  const int width = 1 + int(c.below(std::uint64_t(largest_side)));
  const int height = 1 + int(c.below(std::uint64_t(largest_side)));
  // The right picture may be narrower or wider than the left one.
  const int right_width = c.flag() ? width : 1 + int(c.below(std::uint64_t(largest_side)));
  Picture left = any_picture(c, width, height);
  Picture right = any_picture(c, right_width, height);
  return {"a square", std::move(left), std::move(right), radius, {any_place(c, width, height)}};
}

inline std::vector<InputClass<SadCase>> generated_squares() {
  return {
      {"squares of every size, in the picture and over its edges", 20'000,
       [](Choices& c) {
         const int radius = int(c.below(4));
         return one_square(c, 8, radius);
       }},
      {"squares larger than the picture", 5'000,
       [](Choices& c) {
         const int radius = int(c.below(8));
         return one_square(c, 4, radius);
       }},
      {"wide pictures, with disparities above 255", 500,
       [](Choices& c) {
         const int width = 256 + int(c.below(100));
         Picture left = any_picture(c, width, 1), right = any_picture(c, width, 1);
         const int x = width - 1 - int(c.below(8));
         const int radius = int(c.below(3));
         return SadCase{
             "a square", std::move(left), std::move(right), radius, {{x, 0, x - int(c.below(8))}}};
       }},
      {"the largest sums", 2'000, [](Choices& c) {
         const int width = 1 + int(c.below(9)), height = 1 + int(c.below(9));
         const auto pixels = std::size_t(width * height);
         const bool white = c.flag();
         Picture left{width, height, std::vector<int>(pixels, white ? 255 : 0)};
         Picture right{width, height, std::vector<int>(pixels, white ? 0 : 255)};
         const int radius = 7 - int(c.below(3));
         return SadCase{
             "a square", std::move(left), std::move(right), radius, {any_place(c, width, height)}};
       }}};
}

inline CensusCase one_word(Choices& c, int largest_side) {
  const int width = 1 + int(c.below(std::uint64_t(largest_side)));
  const int height = 1 + int(c.below(std::uint64_t(largest_side)));
  Picture picture = any_picture(c, width, height);
  const int x = int(c.below(std::uint64_t(width)));
  return {"a pixel", std::move(picture), {{x, int(c.below(std::uint64_t(height))), 0}}};
}

inline std::vector<InputClass<CensusCase>> generated_words() {
  return {{"pixels anywhere in pictures of every size", 30'000,
           [](Choices& c) { return one_word(c, 9); }},
          {"pictures smaller than the square", 10'000, [](Choices& c) { return one_word(c, 4); }}};
}

inline std::vector<InputClass<HammingCase>> generated_pairs_of_words() {
  return {{"words that differ in one bit or two", 20'000,
           [](Choices& c) {
             const auto a = std::uint32_t(c.below(std::uint64_t(1) << 32));
             const auto first = std::uint32_t(1) << c.below(32);
             return HammingCase{"two words", a, a ^ first ^ (std::uint32_t(1) << c.below(32))};
           }},
          {"any words", 20'000,
           [](Choices& c) {
             const auto a = std::uint32_t(c.below(std::uint64_t(1) << 32));
             return HammingCase{"two words", a, std::uint32_t(c.below(std::uint64_t(1) << 32))};
           }},
          {"words of which all bits are 0 or all are 1", 100, [](Choices& c) {
             const auto a = c.one_of<std::uint32_t>({0, 0xffffff, 0xffffffff});
             return HammingCase{"two words", a, c.one_of<std::uint32_t>({0, 0xffffff, 0xffffffff})};
           }}};
}

// ---- costs (tasks 11.3 to 11.5) ----

// The kind of a list of costs; each list has one.
struct Costs {
  std::uint64_t kind = 0;
  int any(Choices& c) const {
    switch (kind) {
      case 0:
        return int(c.below(3));  // many of them are equal
      case 1:
        return int(c.below(256));
      case 2:
        return c.below(3) == 0 ? kNever : int(c.below(4));
      case 3:
        return kNever - int(c.below(3));
      default:
        return int(c.below(std::uint64_t(kNever) + 1));
    }
  }
};
inline Costs any_costs(Choices& c) {
  return {c.below(5)};
}
inline std::vector<int> list_of_costs(Choices& c, int count) {
  const Costs costs = any_costs(c);
  std::vector<int> list(std::size_t(count), 0);
  for (int& cost : list) cost = costs.any(c);
  return list;
}

inline PathCase one_path(Choices& c, int most_pixels, int most_disparities) {
  const int disparities = 1 + int(c.below(std::uint64_t(most_disparities)));
  const int pixels = 1 + int(c.below(std::uint64_t(most_pixels)));
  // The penalties have every size; P1 is often 0 or P2.
  const std::int64_t p2 = std::abs(c.sized(16));
  const std::int64_t p1 = c.one_of<std::int64_t>({0, p2, c.integer(0, p2), c.integer(0, p2 / 4)});
  return {"a path", list_of_costs(c, pixels * disparities), disparities, int(p1), int(p2)};
}

inline std::vector<InputClass<PathCase>> generated_paths() {
  return {
      {"short paths of costs of every size", 30'000, [](Choices& c) { return one_path(c, 4, 6); }},
      {"longer paths of more disparities", 3'000, [](Choices& c) { return one_path(c, 20, 20); }}};
}

inline std::vector<InputClass<WinnerCase>> generated_winners() {
  return {{"costs of every size, and no costs", 50'000,
           [](Choices& c) {
             const int count = int(c.below(9));
             return WinnerCase{"costs", list_of_costs(c, count)};
           }},
          {"a lowest cost, its neighbours and many others", 20'000, [](Choices& c) {
             const int at = int(c.below(300)), after = int(c.below(3));
             // The others cost more than the lowest one by at least 1.
             const int lowest = int(c.below(std::uint64_t(kNever)));
             WinnerCase made{"costs", std::vector<int>(std::size_t(at + 1 + after), kNever)};
             made.costs[std::size_t(at)] = lowest;
             const auto dearer = [&](bool equal_too) {
               const int least = std::min(lowest + (equal_too ? 0 : 1), kNever);
               return c.flag() ? int(c.integer(least, std::min(least + 3, kNever)))
                               : int(c.integer(least, kNever));
             };
             if (at > 0) made.costs[std::size_t(at) - 1] = dearer(false);
             if (after > 0) made.costs[std::size_t(at) + 1] = dearer(true);
             return made;
           }}};
}

inline RowCase one_row(Choices& c, int most_pixels, int most_disparities) {
  const int width = 1 + int(c.below(std::uint64_t(most_pixels)));
  const int disparities = 1 + int(c.below(std::uint64_t(most_disparities)));
  RowCase made{"a row", list_of_costs(c, width * disparities), width, disparities};
  // The costs of matches beside the right picture: kNever, or costs that must not be used.
  if (c.flag()) return made;
  for (int x = 0; x < width; ++x) {
    for (int d = x + 1; d < disparities; ++d) made.costs[std::size_t(x * disparities + d)] = kNever;
  }
  return made;
}

inline std::vector<InputClass<RowCase>> generated_rows() {
  return {{"rows of a few pixels, also with more disparities than pixels", 40'000,
           [](Choices& c) { return one_row(c, 6, 6); }},
          {"longer rows", 3'000, [](Choices& c) { return one_row(c, 24, 16); }}};
}

// A disparity of a row: a whole one, a half or a double beside it, any, or none.
inline double any_disparity(Choices& c, int width, std::uint64_t kinds) {
  const auto largest = std::int64_t(width) + 1;
  switch (c.below(kinds)) {
    case 0:
      return double(c.integer(0, largest));
    case 1:
      return double(2 * c.integer(0, largest) + 1) / 2;
    case 2:
      return c.near(double(2 * c.integer(0, largest) + 1) / 2);
    case 3:
      return c.multiple(0, largest, 8);
    case 4:
      return c.positive(-60, 5);
    default:
      return kNone;
  }
}

inline CheckCase one_pair_of_rows(Choices& c, std::uint64_t kinds) {
  const int width = 1 + int(c.below(12));
  CheckCase made{"two rows", {}, {}, 0};
  for (int x = 0; x < width; ++x) {
    made.left.push_back(any_disparity(c, width, kinds));
    made.right.push_back(any_disparity(c, width, kinds));
  }
  made.tolerance = c.one_of({0.0, 1.0, 0.5, c.multiple(0, 4, 8), c.positive(-4, 4)});
  return made;
}

// The right row has nearly the same disparity as the left one where it is looked up: the difference
// is the tolerance, or beside it.
inline CheckCase rows_of_a_wall(Choices& c) {
  const int width = 1 + int(c.below(12));
  CheckCase made{"two rows of a wall", {}, {}, c.multiple(0, 3, 4)};
  const double wall = c.multiple(1, 5, 4);
  for (int x = 0; x < width; ++x) {
    made.left.push_back(wall + c.multiple(0, 1, 4));
    const double off = c.one_of({0.0, 1.0, -1.0}) * made.tolerance;
    made.right.push_back(c.below(8) == 7 ? kNone : c.near(std::abs(wall + off)));
  }
  return made;
}

inline std::vector<InputClass<CheckCase>> generated_pairs_of_rows() {
  return {{"whole disparities, halves and the doubles beside halves", 20'000,
           [](Choices& c) { return one_pair_of_rows(c, 3); }},
          {"rows with all kinds of disparities, and pixels without one", 20'000,
           [](Choices& c) { return one_pair_of_rows(c, 6); }},
          {"differences of the tolerance and beside it", 20'000, rows_of_a_wall}};
}

// ---- depths (task 11.6) ----

inline DepthCase one_depth(double disparity, double focal, double baseline, double offset) {
  return {"a depth", disparity, {focal, baseline, offset}};
}
inline double any_length(Choices& c) {
  return c.positive(-299, 298);
}

inline std::vector<InputClass<DepthCase>> generated_depths() {
  return {{"disparities and cameras of usual sizes", 40'000,
           [](Choices& c) {
             const double disparity = c.multiple(-8, 64, c.flag() ? 1024 : 1);
             const double focal = c.positive(4, 12);
             const double baseline = c.positive(-6, 10);
             return one_depth(disparity, focal, baseline, c.flag() ? 0 : c.real(-4, 6));
           }},
          {"d + offset is 0, or as near to it as doubles allow", 30'000,
           [](Choices& c) {
             const double offset = c.flag() ? c.real(-20, 10) : c.multiple(-8, 8, 8);
             const double disparity = offset == 0 ? c.one_of({0.0, -0.0}) : c.near(-offset);
             const double focal = c.positive(4, 12);
             return one_depth(disparity, focal, c.positive(-6, 10), offset);
           }},
          {"numbers of every size", 20'000,
           [](Choices& c) {
             const double disparity = c.real(-299, 298), focal = any_length(c);
             const double baseline = any_length(c);
             const double offset = c.flag() ? c.real(-299, 298) : 0;
             const bool small = std::abs(disparity + offset) < 0x1p-300;
             return one_depth(small ? -offset : disparity, focal, baseline, offset);
           }},
          {"no disparity", 2'000, [](Choices& c) {
             const double focal = any_length(c), baseline = any_length(c);
             return one_depth(kNone, focal, baseline, c.flag() ? c.real(-299, 298) : 0);
           }}};
}

}  // namespace inputs
}  // namespace lab_11
