#include "labs/11-matching/reference.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "base/expansion.h"

namespace glassbox::labs::matching {

using lab_11::kNever;
using lab_11::kNone;

int sad(const Sides& sides, int x, int y, int d, int radius) {
  const int other = x + sides.step * d;
  if (other < 0 || other >= sides.second->width) return kNever;
  int sum = 0;
  for (int row = y - radius; row <= y + radius; ++row) {
    for (int i = -radius; i <= radius; ++i)
      sum += std::abs(sides.first->at(x + i, row) - sides.second->at(other + i, row));
  }
  return sum;
}

std::uint32_t census(const lab_11::Picture& picture, int x, int y) {
  std::uint32_t word = 0;
  for (int number = 0; number < 25; ++number) {
    if (number == 12) continue;
    const int bit = number < 12 ? number : number - 1;
    const bool darker = picture.at(x + number % 5 - 2, y + number / 5 - 2) < picture.at(x, y);
    word |= std::uint32_t(darker) << bit;
  }
  return word;
}

int hamming(std::uint32_t a, std::uint32_t b) {
  int bits = 0;
  for (int i = 0; i < 32; ++i) bits += (a >> i & 1) != (b >> i & 1);
  return bits;
}

std::vector<int> along_path(const std::vector<int>& costs, int disparities, int p1, int p2) {
  const auto count = std::size_t(disparities);
  std::vector<std::int64_t> ways(costs.begin(), costs.end());
  std::vector<int> sums(costs.begin(), costs.end());
  for (std::size_t at = count; at + count <= costs.size(); at += count) {
    const auto before = ways.begin() + std::ptrdiff_t(at - count);
    const std::int64_t least = *std::min_element(before, before + disparities);
    for (int d = 0; d < disparities; ++d) {
      std::int64_t cheapest = INT64_MAX;
      for (int from = 0; from < disparities; ++from) {
        const int change = std::abs(d - from);
        const std::int64_t dear = change == 0 ? 0 : change == 1 ? std::min(p1, p2) : p2;
        cheapest = std::min(cheapest, before[from] + dear);
      }
      ways[at + std::size_t(d)] += cheapest;
      sums[at + std::size_t(d)] = int(ways[at + std::size_t(d)] - least);
    }
  }
  return sums;
}

double winner(const std::vector<int>& costs) {
  std::size_t best = 0;
  for (std::size_t d = 1; d < costs.size(); ++d) {
    if (costs[d] < costs[best]) best = d;
  }
  if (costs.empty() || costs[best] >= kNever) return kNone;
  const double d = double(best);
  if (best == 0 || best + 1 == costs.size()) return d;
  if (costs[best - 1] >= kNever || costs[best + 1] >= kNever) return d;
  const double fall = costs[best - 1] - costs[best], rise = costs[best + 1] - costs[best];
  return d + (fall - rise) / (2 * (fall + rise));
}

std::vector<double> right_winners(const std::vector<int>& costs, int width, int disparities,
                                  int step) {
  std::vector<double> winners(std::size_t(width), kNone);
  std::vector<int> least(std::size_t(width), kNever);
  for (int d = 0; d < disparities; ++d) {
    for (int x = 0; x < width; ++x) {
      const int column = x + step * d;
      if (column < 0 || column >= width) continue;
      const int cost = costs[std::size_t(x * disparities + d)];
      if (cost >= least[std::size_t(column)]) continue;
      least[std::size_t(column)] = cost;
      winners[std::size_t(column)] = d;
    }
  }
  return winners;
}

std::vector<double> left_right_check(const std::vector<double>& left,
                                     const std::vector<double>& right, double tolerance, int step) {
  std::vector<double> checked;
  for (std::size_t x = 0; x < left.size(); ++x) {
    // The column to which x - d is nearest, halves to the right: x minus the column to which d is
    // nearest, halves down. fmod() is exact, so the fraction of d is, too.
    const double fraction = std::isfinite(left[x]) ? std::fmod(left[x], 1.0) : 0;
    const double whole = left[x] - fraction;  // exact
    const bool next = step < 0 ? fraction > 0.5 : fraction >= 0.5;
    const double column = double(x) + step * (whole + (next ? 1 : 0));
    const bool inside = column >= 0 && column < double(right.size());
    const double found = inside ? right[std::size_t(column)] : kNone;
    const bool confirmed = std::isfinite(found) && std::abs(found - left[x]) <= tolerance;
    checked.push_back(confirmed ? left[x] : kNone);
  }
  return checked;
}

double depth(double disparity, const lab_11::Calibration& calibration) {
  const double shift = disparity + calibration.offset;
  if (!(shift > 0) || std::isinf(shift)) return kNone;
  // f B and d + offset without rounding, each as two doubles. The quotient of the first ones has an
  // error of some u of itself, where u is the unit roundoff, which is added to it: what is left is
  // some u^2, and the rounding of this addition.
  const TwoTerms product = two_product(calibration.focal, calibration.baseline);
  const TwoTerms sum = two_sum(disparity, calibration.offset);
  const double z = product.high / sum.high;
  const double missing = std::fma(-z, sum.high, product.high) + product.low - z * sum.low;
  return z + missing / sum.high;
}

}  // namespace glassbox::labs::matching
