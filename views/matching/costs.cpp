#include "views/matching/costs.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <tbb/parallel_for.h>

#include "views/matching/kernels.h"

namespace glassbox::views {

namespace {

// What no match writes: beside the picture, and behind the last disparity.
void fill_row(CostVolume& volume, int row) {
  for (int x = 0; x < volume.width; ++x) {
    std::uint16_t* costs = volume.at(x, row);
    const int from = std::min(volume.from(x), volume.count), to = std::max(from, volume.to(x));
    std::fill(costs, costs + from, kHighestCost);
    std::fill(costs + to, costs + volume.count, kHighestCost);
    std::fill(costs + volume.count, costs + volume.stride, kNeverCost);
  }
}

// Calls one(x, from, to, first_right) for each pixel of a row that has a right pixel at all: of disparity number `from` it is at
// first_right, and of the next ones to the left of it.
template <class One>
void for_matches(const CostVolume& volume, const One& one) {
  for (int x = 0; x < volume.width; ++x) {
    const int from = volume.from(x), to = volume.to(x);
    if (from < to) one(x, from, to, x - (volume.first + from));
  }
}

MatchKernels::Mix mix_of(MatchingCost cost) {
  if (cost == MatchingCost::kCensus) return {16, 32, 0, 0};
  if (cost == MatchingCost::kSad) return {0, 0, 2, 765};
  return {16, 30, 4, 60};
}

void mixed_row(const Planes& left, const Planes& right, const LineVector<std::uint32_t>& left_words,
               const LineVector<std::uint32_t>& right_words, const MatchSettings& settings, int y,
               CostVolume& volume, int to_row) {
  const bool color = settings.cost == MatchingCost::kAdCensus;
  const auto width = std::size_t(left.width), start = std::size_t(y) * width;
  const auto reversed = [&](const auto& values) {
    auto row = std::vector(values.begin() + std::ptrdiff_t(start),
                           values.begin() + std::ptrdiff_t(start + width));
    std::ranges::reverse(row);
    return row;
  };
  const auto words = reversed(right_words);
  const auto r = reversed(color ? right.r : right.grey), g = reversed(color ? right.g : right.grey),
             b = reversed(color ? right.b : right.grey);
  const auto& left_r = color ? left.r : left.grey;
  const auto& left_g = color ? left.g : left.grey;
  const auto& left_b = color ? left.b : left.grey;
  const MatchKernels& kernels = match_kernels(settings.target);
  const MatchKernels::Mix mix = mix_of(settings.cost);
  for_matches(volume, [&](int x, int from, int to, int first_right) {
    const auto at = start + std::size_t(x);
    const int skip = left.width - 1 - first_right;
    kernels.mixed_costs({left_words[at], left_r[at], left_g[at], left_b[at]},
                        {words.data() + skip, r.data() + skip, g.data() + skip, b.data() + skip},
                        to - from, mix, volume.at(x, to_row) + from);
  });
}

// Squares of grey differences reach 65025: a 32nd of it stays below kHighestCost.
void squared_row(const Planes& left, const Planes& right, int y, CostVolume& volume, int to_row) {
  const auto start = std::size_t(y) * std::size_t(left.width);
  for_matches(volume, [&](int x, int from, int to, int first_right) {
    for (int i = from; i < to; ++i) {
      const int difference = int(left.grey[start + std::size_t(x)]) -
                             int(right.grey[start + std::size_t(first_right - (i - from))]);
      volume.at(x, to_row)[i] = std::uint16_t((difference * difference + 16) / 32);
    }
  });
}

struct Sums {
  std::int64_t left = 0, right = 0, left_left = 0, right_right = 0, left_right = 0, count = 0;
};

// (1 - correlation) of half the highest cost; of a window without contrast nothing is known: half.
std::uint16_t correlation_cost(const Sums& sums, bool centred) {
  // Window sums of 8-bit values: at most 225 * 255^2, and the products below 2^53.
  const double n = centred ? double(sums.count) : 0;
  const double k = centred ? double(sums.count) : 1;
  const double covariance =
      k * double(sums.left_right) - (n > 0 ? double(sums.left) * double(sums.right) : 0);
  const double left =
      k * double(sums.left_left) - (n > 0 ? double(sums.left) * double(sums.left) : 0);
  const double right =
      k * double(sums.right_right) - (n > 0 ? double(sums.right) * double(sums.right) : 0);
  const double correlation =
      left > 0 && right > 0 ? covariance / (std::sqrt(left) * std::sqrt(right)) : 0;
  return std::uint16_t(
      std::clamp((1 - correlation) * (kHighestCost / 2) + 0.5, 0.0, double(kHighestCost)));
}

// Both windows are cut at the edge of either picture alike. A column's sums are shared by the windows that hold it.
void correlation_row(const Planes& left, const Planes& right, const MatchSettings& settings, int y,
                     CostVolume& volume, int to_row) {
  const int radius = settings.window / 2, width = left.width;
  const int top = std::max(0, y - radius), bottom = std::min(left.height - 1, y + radius);
  std::vector<Sums> columns(static_cast<std::size_t>(width));
  for (int i = 0; i < volume.count; ++i) {
    const int d = volume.first + i;
    const int begin = std::max(0, d), end = std::min(width, width + d);
    if (begin >= end) continue;
    for (int x = begin; x < end; ++x) {
      Sums sums;
      for (int row = top; row <= bottom; ++row) {
        const auto at = std::size_t(row) * std::size_t(width);
        const std::int64_t a = left.grey[at + std::size_t(x)],
                           b = right.grey[at + std::size_t(x - d)];
        sums.left += a, sums.right += b;
        sums.left_left += a * a, sums.right_right += b * b, sums.left_right += a * b;
      }
      sums.count = bottom - top + 1;
      columns[std::size_t(x)] = sums;
    }
    Sums window;
    const auto change = [&](int x, int sign) {
      if (x < begin || x >= end) return;
      const Sums& column = columns[std::size_t(x)];
      window.left += sign * column.left, window.right += sign * column.right;
      window.left_left += sign * column.left_left, window.right_right += sign * column.right_right;
      window.left_right += sign * column.left_right, window.count += sign * column.count;
    };
    for (int x = begin; x < begin + radius; ++x) change(x, 1);
    for (int x = begin; x < end; ++x) {
      change(x + radius, 1);
      change(x - radius - 1, -1);
      volume.at(x, to_row)[i] = correlation_cost(window, settings.cost == MatchingCost::kZncc);
    }
  }
}

}  // namespace

PixelCosts::PixelCosts(const Planes& left, const Planes& right, const MatchSettings& settings)
    : left_(left),
      right_(right),
      settings_(settings),
      left_words_(census_words(left)),
      right_words_(census_words(right)) {}

CostVolume PixelCosts::volume_of(int rows) const {
  return {left_.width, rows, settings_.range.first, settings_.range.count()};
}

void PixelCosts::row(int y, CostVolume& volume, int to_row) const {
  fill_row(volume, to_row);
  if (is_correlation(settings_.cost)) {
    correlation_row(left_, right_, settings_, y, volume, to_row);
  } else if (settings_.cost == MatchingCost::kSsd) {
    squared_row(left_, right_, y, volume, to_row);
  } else {
    mixed_row(left_, right_, left_words_, right_words_, settings_, y, volume, to_row);
  }
}

CostVolume pixel_costs(const Planes& left, const Planes& right, const MatchSettings& settings) {
  const PixelCosts costs(left, right, settings);
  CostVolume volume = costs.volume_of(left.height);
  tbb::parallel_for(0, left.height, [&](int y) { costs.row(y, volume, y); });
  return volume;
}

}  // namespace glassbox::views
