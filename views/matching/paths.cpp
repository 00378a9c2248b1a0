#include "views/matching/paths.h"

#include <algorithm>
#include <cstdlib>
#include <span>
#include <vector>

#include <tbb/parallel_invoke.h>

#include "views/matching/kernels.h"

namespace glassbox::views {

namespace {

// From the pixel before to this one, in a sweep to the right and down; the sweep up takes the opposites.
struct Step {
  int x, y;
};
constexpr std::array<Step, 8> kSteps{
    {{1, 0}, {0, 1}, {1, 1}, {-1, 1}, {1, 2}, {-1, 2}, {2, 1}, {-2, 1}}};
constexpr int kRowsKept = 3;
constexpr int kGap =
    kDisparityLanes;  // between the values of two pixels: never less than a neighbour

// One direction's values of the rows that are still needed.
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
  LineVector<std::uint16_t> values_, least_;
};

struct Sweep {
  const CostVolume& costs;
  const Planes& picture;
  std::span<const Step> steps;
  const std::array<std::uint16_t, 256>& jumps;
  std::uint16_t p1;
  int sign;  // 1 to the right and down, -1 to the left and up
  const MatchKernels& kernels;
};

void sweep_pixel(const Sweep& sweep, int x, int y, const std::uint16_t* nothing,
                 std::vector<PathRows>& rows, CostVolume& sums) {
  const CostVolume& costs = sweep.costs;
  const auto grey = [&](int column, int row) {
    return int(
        sweep.picture.grey[std::size_t(row) * std::size_t(costs.width) + std::size_t(column)]);
  };
  std::uint16_t* out = sums.at(x, y);
  std::fill_n(out, costs.stride, std::uint16_t(0));
  for (std::size_t i = 0; i < sweep.steps.size(); ++i) {
    const int from_x = x - sweep.sign * sweep.steps[i].x,
              from_y = y - sweep.sign * sweep.steps[i].y;
    const bool begins = from_x < 0 || from_x >= costs.width || from_y < 0 || from_y >= costs.height;
    const std::uint16_t* before = begins ? nothing : rows[i].values(from_x, from_y);
    const std::uint16_t least = begins ? std::uint16_t(0) : rows[i].least(from_x, from_y);
    const int change = begins ? 0 : std::abs(grey(x, y) - grey(from_x, from_y));
    rows[i].least(x, y) = sweep.kernels.path_step(costs.at(x, y), before, least, sweep.p1,
                                                  sweep.jumps[std::size_t(change)], costs.stride,
                                                  rows[i].values(x, y), out);
  }
}

void run(const Sweep& sweep, CostVolume& sums) {
  const CostVolume& costs = sweep.costs;
  // Where a path begins it has the cost alone: as if zeros came before.
  const LineVector<std::uint16_t> zeros(std::size_t(costs.stride + 2 * kGap));
  std::vector<PathRows> rows(sweep.steps.size(), PathRows(costs.width, costs.stride));
  for (int row = 0; row < costs.height; ++row) {
    const int y = sweep.sign > 0 ? row : costs.height - 1 - row;
    for (int column = 0; column < costs.width; ++column) {
      const int x = sweep.sign > 0 ? column : costs.width - 1 - column;
      sweep_pixel(sweep, x, y, zeros.data() + kGap, rows, sums);
    }
  }
}

}  // namespace

std::array<std::uint16_t, 256> jump_penalties(const Penalties& penalties) {
  std::array<std::uint16_t, 256> jumps{};
  for (int change = 0; change < 256; ++change) {
    const int penalty = penalties.p2 * penalties.half_at / (penalties.half_at + change);
    jumps[std::size_t(change)] = std::uint16_t(std::max(penalty, int(penalties.p2_least)));
  }
  return jumps;
}

PathSums sum_paths(const CostVolume& costs, const Planes& picture, int paths,
                   const Penalties& penalties, Target target) {
  const auto jumps = jump_penalties(penalties);
  const auto steps = std::span(kSteps).first(std::size_t(paths / 2));
  const auto like = [&] { return CostVolume(costs.width, costs.height, costs.first, costs.count); };
  PathSums sums{like(), like()};
  const auto sweep = [&](int sign) {
    return Sweep{costs, picture, steps, jumps, penalties.p1, sign, match_kernels(target)};
  };
  tbb::parallel_invoke([&] { run(sweep(1), sums.down); }, [&] { run(sweep(-1), sums.up); });
  return sums;
}

}  // namespace glassbox::views
