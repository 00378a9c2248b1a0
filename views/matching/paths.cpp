#include "views/matching/paths.h"

#include <algorithm>
#include <span>
#include <vector>

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include "views/matching/kernels.h"

namespace glassbox::views {

namespace {

// The step from a path's previous pixel to the current one, in a sweep downwards. A sweep upwards
// takes the opposite steps.
struct Step {
  int x, y;
};
constexpr std::array<Step, 8> kSteps{
    {{1, 0}, {0, 1}, {1, 1}, {-1, 1}, {1, 2}, {-1, 2}, {2, 1}, {-2, 1}}};
constexpr int kRowsKept = 3;
// Entries between the values of two pixels, which are always 65535. A step reads the disparities
// just outside of the range, too, and these must never be the least.
constexpr int kGap = kDisparityLanes;

// The path values of one direction, for the rows that are still needed.
class PathRows {
public:
  PathRows(int width, int stride)
      : width_(std::size_t(width)),
        cell_(std::size_t(stride + kGap)),
        values_(kRowsKept * width_ * cell_ + kGap, 65535),
        least_(kRowsKept * width_) {}

  std::uint16_t* values(int x, int y) { return values_.data() + kGap + place(x, y) * cell_; }
  std::uint16_t& least(int x, int y) { return least_[place(x, y)]; }

private:
  std::size_t place(int x, int y) const {
    return std::size_t(y % kRowsKept) * width_ + std::size_t(x);
  }

  std::size_t width_, cell_;
  CacheAlignedVector<std::uint16_t> values_, least_;
};

struct Sweep {
  const ColorPlanes& picture;
  std::span<const Step> steps;  // from a path's previous pixel to the current one
  const std::array<std::uint16_t, 256>& jumps;
  std::uint16_t p1;
  const MatchKernels& kernels;
};

class Sweeper {
public:
  Sweeper(const Sweep& sweep, int stride)
      : sweep_(sweep),
        stride_(stride),
        zeros_(std::size_t(stride + 2 * kGap)),
        rows_(sweep.steps.size(), PathRows(sweep.picture.width, stride)) {}

  // Computes the paths in the picture's row y, whose costs and sums begin at the pointers. The
  // sweep covers the rows from `begin` to `end` - 1; no path comes from a row outside.
  void row(int y, int begin, int end, const std::uint16_t* costs, std::uint16_t* sums) {
    for (std::size_t i = 0; i < sweep_.steps.size(); ++i) {
      const Step step = sweep_.steps[i];
      const int before = y - step.y;
      const bool exists = before >= begin && before < end;
      sweep_.kernels.path_row({.width = sweep_.picture.width,
                               .stride = stride_,
                               .cell = stride_ + kGap,
                               .from = step.x,
                               .leftwards = step.x < 0,
                               .begins_sums = i == 0,
                               .p1 = sweep_.p1,
                               .jumps = sweep_.jumps.data(),
                               .costs = costs,
                               .grey = grey(y),
                               .grey_before = exists ? grey(before) : nullptr,
                               .before = exists ? rows_[i].values(0, before) : nullptr,
                               .least_before = exists ? &rows_[i].least(0, before) : nullptr,
                               .nothing = zeros_.data() + kGap,
                               .values = rows_[i].values(0, y),
                               .least = &rows_[i].least(0, y),
                               .sums = sums});
    }
  }

private:
  const std::uint8_t* grey(int y) const {
    return sweep_.picture.grey.data() + std::size_t(y) * std::size_t(sweep_.picture.width);
  }

  Sweep sweep_;
  int stride_;
  // The values before a path's first pixel: with zeros there, the first value is the cost alone.
  CacheAlignedVector<std::uint16_t> zeros_;
  std::vector<PathRows> rows_;
};

void sweep_all(const Sweep& sweep, const CostVolume& costs, bool upwards, CostVolume& sums) {
  Sweeper sweeper(sweep, costs.stride);
  for (int row = 0; row < costs.height; ++row) {
    const int y = upwards ? costs.height - 1 - row : row;
    sweeper.row(y, 0, costs.height, costs.at(0, y), sums.at(0, y));
  }
}

std::vector<Step> opposite(std::span<const Step> steps) {
  std::vector<Step> result;
  for (const Step step : steps) result.push_back({-step.x, -step.y});
  return result;
}

constexpr int kBandRows = 64;  // px
// The number of rows above a band that are swept first. After them it has little influence where
// the paths began.
constexpr int kWarmUp = 8;

}  // namespace

std::array<std::uint16_t, 256> jump_penalties(const Penalties& penalties) {
  std::array<std::uint16_t, 256> jumps{};
  for (int change = 0; change < 256; ++change) {
    const int penalty = penalties.p2 * penalties.half_at / (penalties.half_at + change);
    jumps[std::size_t(change)] = std::uint16_t(std::max(penalty, int(penalties.p2_least)));
  }
  return jumps;
}

PathSums sum_paths(const CostVolume& costs, const ColorPlanes& picture, int paths,
                   const Penalties& penalties, Target target) {
  const auto jumps = jump_penalties(penalties);
  const auto steps = std::span(kSteps).first(std::size_t(paths / 2));
  const auto like = [&] { return CostVolume(costs.width, costs.height, costs.first, costs.count); };
  PathSums sums{like(), like()};
  const std::vector<Step> back = opposite(steps);
  const MatchKernels& kernels = match_kernels(target);
  const Sweep down{picture, steps, jumps, penalties.p1, kernels};
  const Sweep up{picture, back, jumps, penalties.p1, kernels};
  tbb::parallel_invoke([&] { sweep_all(down, costs, false, sums.down); },
                       [&] { sweep_all(up, costs, true, sums.up); });
  return sums;
}

std::uint64_t bands_of(int height) {
  return std::uint64_t((height + kBandRows - 1) / kBandRows);
}

BandRows band_rows(int band, int height) {
  const int begin = band * kBandRows;
  return {std::max(0, begin - kWarmUp), begin, std::min(height, begin + kBandRows)};
}

DisparityMaps sweep_once(const PixelCosts& costs, const ColorPlanes& picture,
                         const MatchSettings& settings, const Penalties& penalties,
                         CostVolume* kept) {
  const auto jumps = jump_penalties(penalties);
  std::vector<Step> steps(kSteps.begin(), kSteps.begin() + settings.paths / 2);
  steps.push_back({-1, 0});
  const Sweep sweep{picture, steps, jumps, penalties.p1, match_kernels(settings.target)};
  DisparityMaps winners = no_winners(picture.width, picture.height);
  tbb::parallel_for(0, int(bands_of(picture.height)), [&](int band) {
    const auto [first, begin, end] = band_rows(band, picture.height);
    CostVolume one = costs.volume_of(1), sums = costs.volume_of(1);
    Sweeper sweeper(sweep, one.stride);
    for (int y = first; y < end; ++y) {
      costs.row(y, one, 0);
      sweeper.row(y, first, end, one.at(0, 0), sums.at(0, 0));
      if (y < begin) continue;
      winners_of_row(sums, nullptr, 0, y, settings.subpixel, settings.target, winners);
      if (kept) std::ranges::copy(sums.costs, kept->at(0, y));
    }
  });
  return winners;
}

}  // namespace glassbox::views
