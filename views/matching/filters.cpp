#include "views/matching/filters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <tbb/parallel_for.h>

#include "views/matching/kernels.h"
#include "views/matching/winner.h"

namespace glassbox::views {

namespace {

constexpr float kConnected = 1;  // px
constexpr int kSmoothReach = 2;  // px

int nearest_column(int x, float disparity) {
  return int(std::floor(float(x) - disparity + 0.5f));
}

// The reason why the left pixel x failed the left-right check: it is mismatched if the disparity of
// some right pixel leads to it, and else occluded.
InvalidReason failed_check_of(const std::vector<std::uint8_t>& is_claimed, int x) {
  return is_claimed[std::size_t(x)] ? InvalidReason::kMismatched : InvalidReason::kOccluded;
}

// The median of the finite values in the 3 x 3 neighbourhood.
float median_at(const Image<float>& disparity, int x, int y) {
  std::array<float, 9> values;
  std::size_t count = 0;
  for (int row = std::max(y - 1, 0); row <= std::min(y + 1, disparity.height - 1); ++row) {
    for (int column = std::max(x - 1, 0); column <= std::min(x + 1, disparity.width - 1);
         ++column) {
      const float value = disparity.at(column, row);
      if (std::isfinite(value)) values[count++] = value;
    }
  }
  const auto middle = values.begin() + std::ptrdiff_t((count - 1) / 2);
  std::nth_element(values.begin(), middle, values.begin() + std::ptrdiff_t(count));
  return *middle;
}

bool has_gap(const Image<float>& disparity, int x, int y) {
  float greatest = 0;  // the only value that is not finite is +inf
  for (int row = y - 1; row <= y + 1; ++row) {
    const float* values = &disparity.at(x - 1, row);
    greatest = std::max({greatest, values[0], values[1], values[2]});
  }
  return !std::isfinite(greatest);
}

struct Ordered {
  float low, middle, high;
};

Ordered ordered(float a, float b, float c) {
  const float low = std::min(a, b), high = std::max(a, b);
  const float middle = std::max(low, std::min(high, c));
  return {std::min(low, c), middle, std::max(high, c)};
}

// For three columns that are each sorted, the median of the nine numbers is the median of three:
// the greatest of the columns' least, the median of their medians, and the least of their greatest.
// There are no branches, so that the compiler vectorises the loop.
void inner_medians(const Image<float>& disparity, int y, Image<float>& result) {
  const float *above = &disparity.at(0, y - 1), *own = &disparity.at(0, y),
              *below = &disparity.at(0, y + 1);
  float* out = &result.at(0, y);
  for (int x = 1; x + 1 < disparity.width; ++x) {
    const Ordered a = ordered(above[x - 1], own[x - 1], below[x - 1]);
    const Ordered b = ordered(above[x], own[x], below[x]);
    const Ordered c = ordered(above[x + 1], own[x + 1], below[x + 1]);
    out[x] = ordered(std::max({a.low, b.low, c.low}), ordered(a.middle, b.middle, c.middle).middle,
                     std::min({a.high, b.high, c.high}))
                 .middle;
  }
}

}  // namespace

Image<InvalidReason> left_right_check(const Image<float>& left, const Image<float>& right,
                                      int tolerance) {
  Image<InvalidReason> invalid_reasons(left.width, left.height, InvalidReason::kNone);
  tbb::parallel_for(0, left.height, [&](int y) {
    std::vector<std::uint8_t> is_claimed(static_cast<std::size_t>(left.width));
    for (int x = 0; x < right.width; ++x) {
      if (!std::isfinite(right.at(x, y))) continue;
      const int column = x + int(right.at(x, y));
      if (column >= 0 && column < left.width) is_claimed[std::size_t(column)] = 1;
    }
    for (int x = 0; x < left.width; ++x) {
      const float disparity = left.at(x, y);
      if (!std::isfinite(disparity)) {
        invalid_reasons.at(x, y) = InvalidReason::kOutside;
        continue;
      }
      const int column = nearest_column(x, disparity);
      const bool agrees = column >= 0 && column < right.width &&
                          std::abs(right.at(column, y) - disparity) <= float(tolerance) + 0.5f;
      if (!agrees) invalid_reasons.at(x, y) = failed_check_of(is_claimed, x);
    }
  });
  return invalid_reasons;
}

void invalidate_empty(const Image<Rgba8>& left, const Image<Rgba8>& right,
                      const Image<float>& disparity, Image<InvalidReason>& invalid_reasons) {
  const auto has_empty = [](const Image<Rgba8>& picture) {
    return std::ranges::any_of(picture.pixels, [](const Rgba8& pixel) { return pixel.a == 0; });
  };
  if (!has_empty(left) && !has_empty(right)) return;
  tbb::parallel_for(0, left.height, [&](int y) {
    for (int x = 0; x < left.width; ++x) {
      if (!std::isfinite(disparity.at(x, y))) continue;
      // With its fraction, a disparity can lead to half a pixel outside of the picture at most.
      const int column = std::clamp(nearest_column(x, disparity.at(x, y)), 0, right.width - 1);
      if (left.at(x, y).a == 0 || right.at(column, y).a == 0)
        invalid_reasons.at(x, y) = InvalidReason::kOutside;
    }
  });
}

void invalidate_speckles(const Image<float>& disparity, int least,
                         Image<InvalidReason>& invalid_reasons) {
  std::vector<std::uint8_t> is_seen(disparity.pixels.size());
  std::vector<std::size_t> piece;
  const auto belongs = [&](std::size_t i) {
    return invalid_reasons.pixels[i] == InvalidReason::kNone && std::isfinite(disparity.pixels[i]);
  };
  const auto width = std::size_t(disparity.width);
  for (std::size_t start = 0; start < disparity.pixels.size(); ++start) {
    if (is_seen[start] || !belongs(start)) continue;
    piece.assign(1, start);
    is_seen[start] = 1;
    for (std::size_t next = 0; next < piece.size(); ++next) {
      const std::size_t at = piece[next], x = at % width;
      const auto visit = [&](bool exists, std::size_t neighbour) {
        if (!exists || is_seen[neighbour] || !belongs(neighbour)) return;
        if (std::abs(disparity.pixels[at] - disparity.pixels[neighbour]) > kConnected) return;
        is_seen[neighbour] = 1;
        piece.push_back(neighbour);
      };
      visit(x > 0, at - 1);
      visit(x + 1 < width, at + 1);
      visit(at >= width, at - width);
      visit(at + width < disparity.pixels.size(), at + width);
    }
    if (piece.size() >= std::size_t(least)) continue;
    for (const std::size_t at : piece) invalid_reasons.pixels[at] = InvalidReason::kSpeckle;
  }
}

Image<float> smooth_parts(const Image<float>& disparity, Target target) {
  Image<float> result = disparity;
  // The difference of two infinite numbers is NaN. Within the loop, a pixel without disparity has a
  // finite value that is far from all others.
  constexpr float kFarFromAll = 1e30f;
  Image<float> comparable = disparity;
  for (float& value : comparable.pixels) {
    if (value == kNoDisparity) value = kFarFromAll;
  }
  const MatchKernels& kernels = match_kernels(target);
  const int width = disparity.width, height = disparity.height;
  tbb::parallel_for(0, height, [&](int y) {
    thread_local std::vector<float> sums, counts;
    sums.assign(std::size_t(width), 0);
    counts.assign(std::size_t(width), 0);
    const float* own = &comparable.at(0, y);
    const int top = std::max(y - kSmoothReach, 0), bottom = std::min(y + kSmoothReach, height - 1);
    for (int row = top; row <= bottom; ++row) {
      const float* values = &comparable.at(0, row);
      for (int beside = -kSmoothReach; beside <= kSmoothReach; ++beside) {
        const int begin = std::max(0, -beside), end = std::min(width, width - beside);
        if (begin >= end) continue;
        kernels.add_near(own + begin, values + begin + beside, end - begin, kSmoothed,
                         sums.data() + begin, counts.data() + begin);
      }
    }
    for (int x = 0; x < width; ++x) {
      const float count = counts[std::size_t(x)];  // never 0: each pixel is near itself
      if (disparity.at(x, y) != kNoDisparity) {
        result.at(x, y) = own[x] + sums[std::size_t(x)] / count;
      }
    }
  });
  return result;
}

Image<float> median_of(const Image<float>& disparity) {
  Image<float> result = disparity;
  tbb::parallel_for(0, disparity.height, [&](int y) {
    const bool has_rows = y > 0 && y + 1 < disparity.height;
    if (has_rows) inner_medians(disparity, y, result);
    for (int x = 0; x < disparity.width; ++x) {
      if (!std::isfinite(disparity.at(x, y))) {
        result.at(x, y) = kNoDisparity;
      } else if (!has_rows || x == 0 || x + 1 == disparity.width || has_gap(disparity, x, y)) {
        result.at(x, y) = median_at(disparity, x, y);
      }
    }
  });
  return result;
}

}  // namespace glassbox::views
