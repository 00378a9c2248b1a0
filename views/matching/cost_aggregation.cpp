#include "views/matching/cost_aggregation.h"

#include <algorithm>

#include <tbb/parallel_for.h>

#include "views/matching/kernels.h"

namespace glassbox::views {

namespace {

constexpr int kLong = 17;               // px
constexpr int kNear = 20, kNearer = 6;  // sRGB codes: greatest differences of a channel

// The length of an arm, at most `most` pixels. It begins beside the pixel `at`, and its pixels are
// `step` apart.
std::uint8_t arm(const ColorPlanes& picture, std::size_t at, std::ptrdiff_t step, int most) {
  int length = 0;
  for (auto place = std::ptrdiff_t(at) + step; length < most; place += step, ++length) {
    const int difference = channel_difference(picture, at, std::size_t(place));
    if (difference > (length < kLong ? kNear : kNearer)) break;
  }
  return std::uint8_t(length);
}

// Averages the costs of one row or column of `length` pixels: cells(i) are the costs of pixel i,
// and reach(i) is how far its window reaches backwards and forwards.
template <class Cells, class Reach>
void average_line(int length, int stride, const MatchKernels& kernels,
                  CacheAlignedVector<std::uint32_t>& sums, const Cells& cells, const Reach& reach) {
  const auto width = std::size_t(stride);
  sums.resize(std::size_t(length + 1) * width);
  std::fill_n(sums.begin(), width, 0u);
  for (int i = 0; i < length; ++i) {
    std::uint32_t* before = sums.data() + std::size_t(i) * width;
    kernels.running_sum(before, cells(i), stride, before + width);
  }
  for (int i = 0; i < length; ++i) {
    const auto [before, behind] = reach(i);
    kernels.mean(sums.data() + std::size_t(i - before) * width,
                 sums.data() + std::size_t(i + behind + 1) * width,
                 1.0f / float(before + behind + 1), stride, cells(i));
  }
}

struct Reach {
  int before, behind;
};

void average_rows(CostVolume& volume, const Image<Arms>& arms, const MatchKernels& kernels) {
  tbb::parallel_for(0, volume.height, [&](int y) {
    thread_local CacheAlignedVector<std::uint32_t> sums;
    average_line(
        volume.width, volume.stride, kernels, sums, [&](int x) { return volume.at(x, y); },
        [&](int x) {
          const Arms& of = arms.at(x, y);
          return Reach{of.left, of.right};
        });
  });
}

void average_columns(CostVolume& volume, const Image<Arms>& arms, const MatchKernels& kernels) {
  tbb::parallel_for(0, volume.width, [&](int x) {
    thread_local CacheAlignedVector<std::uint32_t> sums;
    average_line(
        volume.height, volume.stride, kernels, sums, [&](int y) { return volume.at(x, y); },
        [&](int y) {
          const Arms& of = arms.at(x, y);
          return Reach{of.up, of.down};
        });
  });
}

}  // namespace

Image<Arms> adaptive_arms(const ColorPlanes& picture, int longest) {
  const auto most = [&](int room) { return std::min(room, longest); };
  Image<Arms> arms(picture.width, picture.height);
  tbb::parallel_for(0, picture.height, [&](int y) {
    for (int x = 0; x < picture.width; ++x) {
      const std::size_t at = arms.index(x, y);
      const std::ptrdiff_t row = picture.width;
      arms.pixels[at] = {
          arm(picture, at, -1, most(x)), arm(picture, at, 1, most(picture.width - 1 - x)),
          arm(picture, at, -row, most(y)), arm(picture, at, row, most(picture.height - 1 - y))};
    }
  });
  return arms;
}

Image<Arms> square_arms(int width, int height, int radius) {
  Image<Arms> arms(width, height);
  const auto most = [&](int room) { return std::uint8_t(std::min(room, radius)); };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      arms.at(x, y) = {most(x), most(width - 1 - x), most(y), most(height - 1 - y)};
    }
  }
  return arms;
}

void average_costs(CostVolume& volume, const Image<Arms>& arms, AggregationOrder first,
                   Target target) {
  const MatchKernels& kernels = match_kernels(target);
  if (first == AggregationOrder::kRows) average_rows(volume, arms, kernels);
  average_columns(volume, arms, kernels);
  if (first == AggregationOrder::kColumns) average_rows(volume, arms, kernels);
}

}  // namespace glassbox::views
