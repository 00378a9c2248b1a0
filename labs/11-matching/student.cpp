// Lab 11: your part. student.h says what each function must do, handout.md why.
#include "student.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

namespace lab_11 {

// ---- task 11.1: how unlike two squares are ----

int sad(const Picture& left, const Picture& right, int x, int y, int d, int radius) {
  // BEGIN SOLUTION
  if (x - d < 0 || x - d >= right.width) return kNever;
  int sum = 0;
  for (int j = -radius; j <= radius; ++j) {
    for (int i = -radius; i <= radius; ++i)
      sum += std::abs(left.at(x + i, y + j) - right.at(x + i - d, y + j));
  }
  return sum;
  // STUB: return -1;
  // END SOLUTION
}

// ---- task 11.2: a measure that a change of brightness does not change ----

std::uint32_t census(const Picture& picture, int x, int y) {
  // BEGIN SOLUTION
  std::uint32_t word = 0, bit = 1;
  for (int j = -2; j <= 2; ++j) {
    for (int i = -2; i <= 2; ++i) {
      if (i == 0 && j == 0) continue;
      if (picture.at(x + i, y + j) < picture.at(x, y)) word |= bit;
      bit <<= 1;
    }
  }
  return word;
  // STUB: return 0xffffffff;
  // END SOLUTION
}

int hamming(std::uint32_t a, std::uint32_t b) {
  // BEGIN SOLUTION
  return std::popcount(a ^ b);
  // STUB: return -1;
  // END SOLUTION
}

// ---- task 11.3: smoothness along a path ----

std::vector<int> along_path(const std::vector<int>& costs, int disparities, int p1, int p2) {
  // BEGIN SOLUTION
  std::vector<int> sums = costs;
  const auto count = std::size_t(disparities);
  for (std::size_t at = count; at < costs.size(); at += count) {
    const int* before = &sums[at - count];
    const int least = *std::min_element(before, before + count);
    for (std::size_t d = 0; d < count; ++d) {
      int best = std::min(before[d], least + p2);
      if (d > 0) best = std::min(best, before[d - 1] + p1);
      if (d + 1 < count) best = std::min(best, before[d + 1] + p1);
      sums[at + d] = costs[at + d] + best - least;
    }
  }
  return sums;
  // STUB: return {};  // a sum for each cost
  // END SOLUTION
}

// ---- task 11.4: the disparity that costs least ----

double winner(const std::vector<int>& costs) {
  // BEGIN SOLUTION
  const std::size_t d = std::size_t(std::min_element(costs.begin(), costs.end()) - costs.begin());
  if (costs.empty() || costs[d] >= kNever) return kNone;
  if (d == 0 || d + 1 == costs.size()) return double(d);
  const int before = costs[d - 1], here = costs[d], after = costs[d + 1];
  const int divisor = 2 * (before - 2 * here + after);
  if (before >= kNever || after >= kNever) return double(d);
  return double(d) + double(before - after) / double(divisor);
  // STUB: return -1;
  // END SOLUTION
}

// ---- task 11.5: what both pictures agree on ----

std::vector<double> right_winners(const std::vector<int>& costs, int width, int disparities) {
  // BEGIN SOLUTION
  std::vector<double> winners(std::size_t(width), kNone);
  for (int x = 0; x < width; ++x) {
    int least = kNever;
    for (int d = 0; d < disparities && x + d < width; ++d) {
      const int cost = costs[std::size_t(x + d) * std::size_t(disparities) + std::size_t(d)];
      if (cost >= least) continue;
      least = cost;
      winners[std::size_t(x)] = d;
    }
  }
  return winners;
  // STUB: return {};
  // END SOLUTION
}

std::vector<double> left_right_check(const std::vector<double>& left,
                                     const std::vector<double>& right, double tolerance) {
  // BEGIN SOLUTION
  std::vector<double> checked = left;
  for (std::size_t x = 0; x < left.size(); ++x) {
    // floor(x - d + 1/2) is x - ceil(d - 1/2), in which nothing is rounded: x - d may round up to
    // a half, as it does for x = 2 and the double above d = 1/2, and d - 1/2 does not.
    const double column = double(x) - std::ceil(left[x] - 0.5);
    const bool inside = column >= 0 && column < double(right.size());
    if (!inside || !(std::abs(left[x] - right[std::size_t(column)]) <= tolerance))
      checked[x] = kNone;
  }
  return checked;
  // STUB: return {};
  // END SOLUTION
}

// ---- task 11.6: how far away it is ----

double depth(double disparity, const Calibration& calibration) {
  // BEGIN SOLUTION
  const double shift = disparity + calibration.offset;
  if (std::isinf(disparity) || shift <= 0) return kNone;
  return calibration.focal * calibration.baseline / shift;
  // STUB: return -1;
  // END SOLUTION
}

}  // namespace lab_11
