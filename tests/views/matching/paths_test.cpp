// S2-04, D-20: sums along paths, compared with the recursion, written out for single directions.
#include <tests/support/catch.h>

#include <cstdlib>
#include <vector>

#include "tests/views/matching/known_pairs.h"
#include "views/matching/byte_sweep.h"
#include "views/matching/costs.h"
#include "views/matching/paths.h"

namespace glassbox::views {
namespace {

constexpr int kPathColumns = 13, kPathRows = 9, kCount = 20;

using Table = std::vector<int>;  // the disparities of each pixel

// Adds the path costs of one direction to the sums; values are limited to `highest`.
void add_direction(const CostVolume& costs, const ColorPlanes& picture, int dx, int dy, Table& sums,
                   const Penalties& penalties = {}, int highest = 65535) {
  const auto jumps = jump_penalties(penalties);
  Table values(sums.size());
  const auto at = [](int x, int y) { return std::size_t((y * kPathColumns + x) * kCount); };
  for (int row = 0; row < kPathRows; ++row) {
    for (int column = 0; column < kPathColumns; ++column) {
      const int x = dx > 0 || (dx == 0 && dy > 0) ? column : kPathColumns - 1 - column;
      const int y = dy >= 0 ? row : kPathRows - 1 - row;
      const int px = x - dx, py = y - dy;
      const bool begins = px < 0 || py < 0 || px >= kPathColumns || py >= kPathRows;
      for (int d = 0; d < kCount; ++d) {
        int value = costs.at(x, y)[d];
        if (!begins) {
          const int* before = values.data() + at(px, py);
          const int least = *std::min_element(before, before + kCount);
          const auto grey = [&](int a, int b) {
            return int(picture.grey[std::size_t(b * kPathColumns + a)]);
          };
          int best = least + jumps[std::size_t(std::abs(grey(x, y) - grey(px, py)))];
          best = std::min(best, before[d]);
          if (d > 0) best = std::min(best, before[d - 1] + penalties.p1);
          if (d + 1 < kCount) best = std::min(best, before[d + 1] + penalties.p1);
          value += best - least;
        }
        values[at(x, y) + std::size_t(d)] = std::min(value, highest);
      }
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] = std::min(sums[i] + values[i], highest);
}

TEST_CASE("D-20: sums along 2, 4, 8 and 16 paths are the recursion's, on every instruction set") {
  const ColorPlanes left = color_planes(noise(kPathColumns, kPathRows, 1)),
                    right = color_planes(noise(kPathColumns, kPathRows, 2));
  MatchSettings settings;
  settings.range = {0, kCount - 1};
  const CostVolume costs = pixel_costs(left, right, settings);
  const std::vector<std::pair<int, int>> directions{{1, 0}, {0, 1},  {1, 1}, {-1, 1},
                                                    {1, 2}, {-1, 2}, {2, 1}, {-2, 1}};
  for (const Target target : available_targets()) {
    for (const int paths : {2, 4, 8, 16}) {
      Table expected(std::size_t(kPathColumns * kPathRows * kCount));
      for (int i = 0; i < paths / 2; ++i) {
        const auto [dx, dy] = directions[std::size_t(i)];
        add_direction(costs, left, dx, dy, expected);
        add_direction(costs, left, -dx, -dy, expected);
      }
      const PathSums sums = sum_paths(costs, left, paths, {}, target);
      for (int y = 0; y < kPathRows; ++y) {
        for (int x = 0; x < kPathColumns; ++x) {
          for (int d = 0; d < kCount; ++d) {
            INFO(name_of(target) << ", " << paths << " paths: pixel " << x << ", " << y << ", "
                                 << d);
            REQUIRE(sums.down.at(x, y)[d] + sums.up.at(x, y)[d] ==
                    expected[std::size_t((y * kPathColumns + x) * kCount + d)]);
          }
        }
      }
    }
  }
}

TEST_CASE("16 paths of the greatest cost and penalty fit 16 bits") {
  CHECK(16 * (kHighestCost + kHighestPenalty) < 65536);
  const auto jumps = jump_penalties({});
  CHECK(jumps[0] <= kHighestPenalty);
  CHECK(std::is_sorted(jumps.rbegin(), jumps.rend()));
}

MatchSettings fast(DisparityRange range) {
  MatchSettings settings = *settings_named("fast");
  settings.range = range;
  return settings;
}

CostVolume volume_of(const ColorPlanes& picture, const DisparityRange& range) {
  return {picture.width, picture.height, range.first, range.count()};
}

TEST_CASE("D-20: sums in bytes are the recursion's, of at most 24 bits, on every instruction set") {
  const ColorPlanes left = color_planes(noise(kPathColumns, kPathRows, 1)),
                    right = color_planes(noise(kPathColumns, kPathRows, 2));
  // Some of the range is outside the picture, on either side.
  MatchSettings settings = fast({-4, kCount - 5});
  REQUIRE(fits_bytes(settings));
  CostVolume costs = pixel_costs(left, right, settings);
  for (std::uint16_t& cost : costs.costs) {
    cost = cost >= kHighestCost ? std::uint16_t(255)
                                : std::min(std::uint16_t(cost / 16), std::uint16_t(24));
  }
  Table expected(std::size_t(kPathColumns * kPathRows * kCount));
  for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {-1, 0}}) {
    add_direction(costs, left, dx, dy, expected, {.p1 = 6, .p2 = 60, .p2_least = 12, .half_at = 10},
                  255);
  }
  for (const Target target : available_targets()) {
    settings.target = target;
    CostVolume sums = volume_of(left, settings.range);
    sweep_in_bytes(left, right, settings, &sums);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const int x = int(i) / kCount % kPathColumns, y = int(i) / kCount / kPathColumns;
      INFO(name_of(target) << ": pixel " << x << ", " << y << ", " << i % kCount);
      REQUIRE(sums.at(x, y)[i % kCount] == expected[i]);
    }
  }
}

TEST_CASE("D-20: winners of sums in bytes are those of the same sums in a volume") {
  // One of the ranges has disparity numbers that do not fit a byte.
  for (const DisparityRange range :
       {DisparityRange{-4, 15}, DisparityRange{0, 63}, DisparityRange{-20, 290}}) {
    const ColorPlanes left = color_planes(noise(310, 3, 1)),
                      right = color_planes(moved_left(noise(310, 3, 1), 9, 2));
    for (const Target target : available_targets()) {
      MatchSettings settings = fast(range);
      settings.target = target;
      CostVolume sums = volume_of(left, range);
      const DisparityMaps winners = sweep_in_bytes(left, right, settings, &sums);
      const DisparityMaps expected = find_winners(sums, nullptr, true, target);
      INFO(name_of(target) << ", to " << range.last);
      CHECK(winners.left == expected.left);
      CHECK(winners.right == expected.right);
      CHECK(winners.confidence == expected.confidence);
    }
  }
}

}  // namespace
}  // namespace glassbox::views
