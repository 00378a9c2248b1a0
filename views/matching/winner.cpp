#include "views/matching/winner.h"

#include <algorithm>

#include <tbb/parallel_for.h>

#include "views/matching/kernels.h"

namespace glassbox::views {

namespace {

struct Row {
  CacheAlignedVector<std::uint16_t> costs;  // for one pixel
  // For each pixel of the right row, in reversed order: the least cost, and the number of its
  // disparity.
  CacheAlignedVector<std::uint16_t> right, number;
};

void left_winner(const CostVolume& volume, const std::uint16_t* costs, int x, int y, bool subpixel,
                 const MatchKernels& kernels, DisparityMaps& winners) {
  const int from = volume.from(x), to = volume.to(x);
  if (from >= to) return;
  const std::uint16_t least = kernels.least(costs + from, to - from);
  const int best = int(std::find(costs + from, costs + to, least) - costs);
  std::uint16_t second = 65535;
  if (best - 1 > from) second = std::min(second, kernels.least(costs + from, best - 1 - from));
  if (best + 2 < to) second = std::min(second, kernels.least(costs + best + 2, to - best - 2));
  winners.confidence.at(x, y) =
      second == 0 || second == 65535 ? 0 : float(second - least) / float(second);
  const bool inside = subpixel && best > from && best + 1 < to;
  const float part = inside ? corner(costs[best - 1], least, costs[best + 1]) : 0.0f;
  winners.left.at(x, y) = float(volume.first + best) + part;
}

}  // namespace

void winners_of_row(const CostVolume& volume, const CostVolume* more, int from_row, int y,
                    bool subpixel, Target target, DisparityMaps& winners) {
  thread_local Row row;
  const MatchKernels& kernels = match_kernels(target);
  const int width = volume.width;
  row.costs.resize(std::size_t(volume.stride));
  row.right.assign(std::size_t(width), 65535);
  row.number.assign(std::size_t(width), 0);
  for (int x = 0; x < width; ++x) {
    const std::uint16_t* costs = volume.at(x, from_row);
    if (more) {
      std::copy_n(costs, volume.stride, row.costs.begin());
      kernels.add(more->at(x, from_row), volume.stride, row.costs.data());
      costs = row.costs.data();
    }
    left_winner(volume, costs, x, y, subpixel, kernels, winners);
    const int from = volume.from(x), to = volume.to(x);
    if (from >= to) continue;
    const auto start = std::size_t(width - 1 - (x - volume.first - from));
    kernels.keep_less(costs + from, to - from, row.right.data() + start, row.number.data() + start,
                      from);
  }
  for (int x = 0; x < width; ++x) {
    const auto at = std::size_t(width - 1 - x);
    if (row.right[at] != 65535) winners.right.at(x, y) = float(volume.first + row.number[at]);
  }
}

DisparityMaps no_winners(int width, int height) {
  return {{width, height, kNoDisparity}, {width, height, kNoDisparity}, {width, height, 0}};
}

DisparityMaps find_winners(const CostVolume& costs, const CostVolume* more, bool subpixel,
                           Target target) {
  DisparityMaps winners = no_winners(costs.width, costs.height);
  tbb::parallel_for(0, costs.height,
                    [&](int y) { winners_of_row(costs, more, y, y, subpixel, target, winners); });
  return winners;
}

}  // namespace glassbox::views
