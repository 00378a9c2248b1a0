#include "views/matching/match.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <glassbox/base/elapsed.h>
#include <glassbox/render/engine/threads.h>

#include "views/matching/byte_sweep.h"
#include "views/matching/cost_aggregation.h"
#include "views/matching/costs.h"
#include "views/matching/fill_holes.h"
#include "views/matching/paths.h"
#include "views/matching/plane_fitting.h"
#include "views/matching/winner.h"

namespace glassbox::views {

namespace {

class Clock {
public:
  explicit Clock(std::vector<MatchStep>& steps) : steps_(steps) {}
  // Records the time since the last call, or since the beginning, under this name.
  void done(const char* name) {
    steps_.push_back({name, elapsed_ms(last_)});
    last_ = std::chrono::steady_clock::now();
  }

private:
  std::vector<MatchStep>& steps_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

void average(CostVolume& costs, const Image<Arms>& arms, const MatchSettings& settings) {
  if (settings.window > 1 && !is_correlation(settings.cost)) {
    average_costs(costs, square_arms(costs.width, costs.height, settings.window / 2),
                  AggregationOrder::kRows, settings.target);
  }
  for (int round = 0; round < settings.adaptive; ++round) {
    average_costs(costs, arms,
                  round % 2 == 0 ? AggregationOrder::kRows : AggregationOrder::kColumns,
                  settings.target);
  }
}

DisparityMaps winners_of_volume(const ColorPlanes& left, const ColorPlanes& right,
                                const Image<Arms>& arms, const MatchSettings& settings,
                                Clock& clock, DenseMatch& match) {
  CostVolume costs = pixel_costs(left, right, settings);
  clock.done("costs");
  average(costs, arms, settings);
  clock.done("averages");
  if (settings.paths == 0) {
    DisparityMaps winners = find_winners(costs, nullptr, settings.subpixel, settings.target);
    clock.done("winners");
    if (settings.keep_sums) match.sums = std::move(costs);
    return winners;
  }
  PathSums sums = sum_paths(costs, left, settings.paths, Penalties{}, settings.target);
  clock.done("paths");
  DisparityMaps winners = find_winners(sums.down, &sums.up, settings.subpixel, settings.target);
  clock.done("winners");
  if (settings.keep_sums) {
    std::ranges::transform(sums.down.costs, sums.up.costs, sums.down.costs.begin(),
                           [](std::uint16_t a, std::uint16_t b) { return std::uint16_t(a + b); });
    match.sums = std::move(sums.down);
  }
  return winners;
}

Image<InvalidReason> find_invalid(const Image<Rgba8>& left, const Image<Rgba8>& right,
                                  const DisparityMaps& winners, const MatchSettings& settings) {
  Image<InvalidReason> invalid_reasons(winners.left.width, winners.left.height,
                                       InvalidReason::kNone);
  if (settings.left_right) {
    invalid_reasons = left_right_check(winners.left, winners.right, *settings.left_right);
  }
  for (std::size_t i = 0; i < invalid_reasons.pixels.size(); ++i) {
    if (!std::isfinite(winners.left.pixels[i])) invalid_reasons.pixels[i] = InvalidReason::kOutside;
    if (invalid_reasons.pixels[i] == InvalidReason::kNone &&
        winners.confidence.pixels[i] < settings.confidence) {
      invalid_reasons.pixels[i] = InvalidReason::kUnsure;
    }
  }
  invalidate_empty(left, right, winners.left, invalid_reasons);
  if (settings.speckle > 0) invalidate_speckles(winners.left, settings.speckle, invalid_reasons);
  return invalid_reasons;
}

void leave_empty(const Image<Rgba8>& left, Image<float>& disparity) {
  for (std::size_t i = 0; i < left.pixels.size(); ++i) {
    if (left.pixels[i].a == 0) disparity.pixels[i] = kNoDisparity;
  }
}

void run(const Image<Rgba8>& left, const Image<Rgba8>& right, const MatchSettings& settings,
         DenseMatch& match) {
  Clock clock(match.steps);
  const ColorPlanes left_planes = color_planes(left), right_planes = color_planes(right);
  const bool votes = settings.fill && settings.vote;
  Image<Arms> arms;
  if (settings.adaptive > 0 || votes) {
    arms = adaptive_arms(left_planes, settings.adaptive > 0 ? kLongestArm : kVoteReach);
  }
  clock.done("crosses");
  DisparityMaps winners;
  if (fits_bytes(settings)) {
    if (settings.keep_sums)
      match.sums =
          CostVolume(left.width, left.height, settings.range.first, settings.range.count());
    winners = sweep_in_bytes(left_planes, right_planes, settings,
                             settings.keep_sums ? &match.sums : nullptr);
    clock.done("sweep");
  } else if (sweeps_once(settings)) {
    const PixelCosts costs(left_planes, right_planes, settings);
    if (settings.keep_sums) match.sums = costs.volume_of(left.height);
    winners =
        sweep_once(costs, left_planes, settings, {}, settings.keep_sums ? &match.sums : nullptr);
    clock.done("sweep");
  } else {
    winners = winners_of_volume(left_planes, right_planes, arms, settings, clock, match);
  }
  match.invalid_reasons = find_invalid(left, right, winners, settings);
  match.disparity = winners.left;
  match.confidence = winners.confidence;
  clock.done("checks");
  if (settings.planes > 0) {
    fit_planes(left_planes, right_planes, match.invalid_reasons, settings.planes, match.disparity);
    clock.done("planes");
  }
  Image<InvalidReason> invalid_reasons = match.invalid_reasons;
  if (settings.fill) {
    if (votes)
      fill_by_vote(arms, settings.range.first, settings.range.count(), 2, match.disparity,
                   invalid_reasons);
    fill_holes(left_planes, match.disparity, invalid_reasons);
  } else {
    for (std::size_t i = 0; i < invalid_reasons.pixels.size(); ++i) {
      if (invalid_reasons.pixels[i] != InvalidReason::kNone)
        match.disparity.pixels[i] = kNoDisparity;
    }
  }
  leave_empty(left, match.disparity);
  clock.done("holes");
  if (settings.median) match.disparity = median_of(match.disparity);
  clock.done("median");
  if (settings.subpixel && settings.smooth) {
    match.disparity = smooth_parts(match.disparity, settings.target);
    clock.done("parts");
  }
}

}  // namespace

std::uint64_t bytes_of_match(int width, int height, const MatchSettings& settings) {
  const auto lanes = std::uint64_t(kDisparityLanes);
  const std::uint64_t stride =
      (std::uint64_t(std::int64_t(settings.range.last) - settings.range.first + 1) + lanes - 1) /
      lanes * lanes;
  const std::uint64_t row = std::uint64_t(width) * stride * sizeof(std::uint16_t);
  // A band of the single sweep has one row of costs, one row of sums, and three rows of values for
  // each path. For a whole picture the rows of path values are negligible.
  const std::uint64_t kept = settings.keep_sums ? row * std::uint64_t(height) : 0;
  if (fits_bytes(settings)) return bands_of(height) * bytes_of_byte_band(width, int(stride)) + kept;
  if (sweeps_once(settings)) {
    const auto paths = std::uint64_t(settings.paths / 2 + 1);
    return row * bands_of(height) * (2 + 3 * paths) + kept;
  }
  return row * std::uint64_t(height) * (settings.paths > 0 ? 3 : 1);
}

Result<DenseMatch> match_pictures(const Image<Rgba8>& left, const Image<Rgba8>& right,
                                  const MatchSettings& settings, std::uint64_t max_bytes) {
  if (const auto legal = check_settings(settings); !legal) return tl::unexpected(legal.error());
  if (left.width != right.width || left.height != right.height) {
    return fail("the pair",
                fmt::format("the pictures are {} x {} and {} x {}", left.width, left.height,
                            right.width, right.height),
                "give two rectified pictures of one size");
  }
  if (left.width < 2 || left.height < 2) {
    return fail("the pair",
                fmt::format("the pictures have only {} x {} pixels", left.width, left.height),
                "give pictures of at least 2 x 2 pixels");
  }
  if (settings.range.first >= left.width || settings.range.last <= -left.width) {
    return fail(
        "--range",
        fmt::format(
            "with disparities from {} to {} no pixel has a partner in pictures with {} columns",
            settings.range.first, settings.range.last, left.width),
        "give disparities below the width");
  }
  DenseMatch match;
  match.bytes = bytes_of_match(left.width, left.height, settings);
  if (match.bytes > max_bytes) {
    return fail("--range",
                fmt::format("{} x {} pixels with {} disparities take {} MB, but {} MB are allowed",
                            left.width, left.height, settings.range.count(), match.bytes >> 20,
                            max_bytes >> 20),
                "use a shorter range, smaller pictures, or a larger --max-mb");
  }
  if (settings.threads == 0) {
    run(left, right, settings, match);
  } else {
    allow_threads(settings.threads);
    tbb::task_arena arena(settings.threads);
    arena.execute([&] { run(left, right, settings, match); });
  }
  return match;
}

}  // namespace glassbox::views
