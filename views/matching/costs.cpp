#include "views/matching/costs.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <tbb/parallel_for.h>

#include "views/matching/kernels.h"

namespace glassbox::views {

namespace {

constexpr int kBitCost = 16;  // for each differing bit of two census words
// For each level of grey by which two pixels differ: at most 1530 in all, three quarters of
// kHighestCost.
constexpr int kGreyCost = 6;

// Fills the costs that have no right pixel: kHighestCost where it would be outside of the picture,
// and kNeverCost behind the last disparity.
void fill_row(CostVolume& volume, int row) {
  for (int x = 0; x < volume.width; ++x) {
    std::uint16_t* costs = volume.at(x, row);
    const int from = std::min(volume.from(x), volume.count), to = std::max(from, volume.to(x));
    std::fill(costs, costs + from, kHighestCost);
    std::fill(costs + to, costs + volume.count, kHighestCost);
    std::fill(costs + volume.count, costs + volume.stride, kNeverCost);
  }
}

// Calls one(x, from, to, first_right) for each pixel x of a row that has a right pixel for any
// disparity. The disparities with the numbers `from` to `to` - 1 have one: at the column
// first_right for `from`, and one column further to the left for each following number.
template <class One>
void for_matches(const CostVolume& volume, const One& one) {
  for (int x = 0; x < volume.width; ++x) {
    const int from = volume.from(x), to = volume.to(x);
    if (from < to) one(x, from, to, x - (volume.first + from));
  }
}

CacheAlignedVector<std::uint32_t> words_of(const CensusPlanes& planes, int width, int height) {
  CacheAlignedVector<std::uint32_t> words(std::size_t(width) * std::size_t(height));
  tbb::parallel_for(0, height, [&](int y) {
    const auto bytes = planes.row(y);
    std::uint32_t* out = words.data() + std::size_t(y) * std::size_t(width);
    for (int x = 0; x < width; ++x) {
      out[x] = std::uint32_t(bytes[0][x]) << 24 | std::uint32_t(bytes[1][x]) << 16 |
               std::uint32_t(bytes[2][x]) << 8 | std::uint32_t(bytes[3][x]);
    }
  });
  return words;
}

// Calls one(left pixel, right pixels by growing disparity, number of right pixels, their costs) for
// each pixel of a left row that has a right pixel for any disparity.
template <class Value, class One>
void for_rows_of_costs(const CacheAlignedVector<Value>& left,
                       const CacheAlignedVector<Value>& right, int y, CostVolume& volume,
                       int to_row, const One& one) {
  const auto width = std::ptrdiff_t(volume.width), start = y * width;
  std::vector<Value> others(right.begin() + start, right.begin() + start + width);
  std::ranges::reverse(others);
  for_matches(volume, [&](int x, int from, int to, int first_right) {
    one(left[std::size_t(start + x)], others.data() + (width - 1 - first_right), to - from,
        volume.at(x, to_row) + from);
  });
}

// Computes one row of costs from census words and colours. Costs for right pixels outside of the
// picture are computed, too, and overwritten afterwards.
void color_row(const ColorPlanes& left, const ColorPlanes& right, const CensusPlanes& left_bytes,
               const CensusPlanes& left_similar, const CensusPlanes& right_bytes,
               const CensusPlanes& right_similar, const MatchSettings& settings, int y,
               CostVolume& volume, int to_row) {
  const int first = settings.range.first;
  const auto width = std::size_t(left.width), start = std::size_t(y) * width;
  const auto before = std::size_t(std::max(0, -first));
  const auto length = width + std::size_t(std::abs(first)) + std::size_t(volume.stride);
  constexpr std::size_t kChannels = 3;
  thread_local CacheAlignedVector<std::uint8_t> lines;
  lines.assign((2 * kCensusBytes + kChannels) * length, 0);
  std::size_t used = 0;
  const auto reversed = [&](const std::uint8_t* from) {
    std::uint8_t* line = lines.data() + used++ * length;
    std::reverse_copy(from, from + width, line + before);
    return line + std::max(0, first);
  };
  ColorRow row{.width = left.width,
               .stride = volume.stride,
               .left = left_bytes.row(y),
               .left_similar = left_similar.row(y),
               .right = {},
               .right_similar = {},
               .left_color = {left.r.data() + start, left.g.data() + start, left.b.data() + start},
               .right_color = {reversed(right.r.data() + start), reversed(right.g.data() + start),
                               reversed(right.b.data() + start)},
               .census_weight = kBitCost,
               .most_bits = 30,
               .color_weight = 4,
               .most_color = 60,
               .costs = volume.at(0, to_row)};
  for (std::size_t k = 0; k < kCensusBytes; ++k) {
    row.right[k] = reversed(right_bytes.row(y)[k]);
    row.right_similar[k] = reversed(right_similar.row(y)[k]);
  }
  byte_kernels(settings.target).color_costs(row);
}

// Squares of grey differences are at most 65025; divided by 32 they are below kHighestCost.
void squared_row(const ColorPlanes& left, const ColorPlanes& right, int y, CostVolume& volume,
                 int to_row) {
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

// The cost is (1 - correlation) times half the highest cost. For a window without contrast the
// correlation is undefined and taken as 0.
std::uint16_t correlation_cost(const Sums& sums, bool centred) {
  // Sums of products of 8-bit values over a window of at most 225 pixels are at most 225 * 255^2,
  // and the products of sums below are under 2^53, so doubles hold them exactly.
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

// The windows in both pictures are cut off where one of them would leave its picture. The sums over
// a column of the window are computed once, for all windows that contain the column.
void correlation_row(const ColorPlanes& left, const ColorPlanes& right,
                     const MatchSettings& settings, int y, CostVolume& volume, int to_row) {
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

PixelCosts::PixelCosts(const ColorPlanes& left, const ColorPlanes& right,
                       const MatchSettings& settings)
    : left_(left), right_(right), settings_(settings) {
  if (settings.cost == MatchingCost::kCensus) {
    const auto words = [&](const ColorPlanes& picture) {
      return words_of(darker_neighbours(picture, settings.target), picture.width, picture.height);
    };
    left_words_ = words(left), right_words_ = words(right);
  }
  if (settings.cost == MatchingCost::kAdCensus) {
    left_bytes_ = darker_neighbours(left, settings.target);
    right_bytes_ = darker_neighbours(right, settings.target);
    left_similar_ = similar_neighbours(left, settings.target);
    right_similar_ = similar_neighbours(right, settings.target);
  }
}

CostVolume PixelCosts::volume_of(int rows) const {
  return {left_.width, rows, settings_.range.first, settings_.range.count()};
}

void PixelCosts::row(int y, CostVolume& volume, int to_row) const {
  if (settings_.cost == MatchingCost::kAdCensus) {
    color_row(left_, right_, left_bytes_, left_similar_, right_bytes_, right_similar_, settings_, y,
              volume, to_row);
  }
  fill_row(volume, to_row);
  if (settings_.cost == MatchingCost::kAdCensus) return;
  const MatchKernels& kernels = match_kernels(settings_.target);
  if (is_correlation(settings_.cost)) {
    correlation_row(left_, right_, settings_, y, volume, to_row);
  } else if (settings_.cost == MatchingCost::kSsd) {
    squared_row(left_, right_, y, volume, to_row);
  } else if (settings_.cost == MatchingCost::kCensus) {
    for_rows_of_costs(left_words_, right_words_, y, volume, to_row,
                      [&](std::uint32_t word, const auto* others, int count, std::uint16_t* costs) {
                        kernels.census_costs(word, others, count, kBitCost, costs);
                      });
  } else {
    for_rows_of_costs(left_.grey, right_.grey, y, volume, to_row,
                      [&](std::uint8_t grey, const auto* others, int count, std::uint16_t* costs) {
                        kernels.grey_costs(grey, others, count, kGreyCost, costs);
                      });
  }
}

CostVolume pixel_costs(const ColorPlanes& left, const ColorPlanes& right,
                       const MatchSettings& settings) {
  const PixelCosts costs(left, right, settings);
  CostVolume volume = costs.volume_of(left.height);
  tbb::parallel_for(0, left.height, [&](int y) { costs.row(y, volume, y); });
  return volume;
}

}  // namespace glassbox::views
