#include "views/matching/fill_holes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include <tbb/parallel_for.h>

#include "views/matching/winner.h"

namespace glassbox::views {

namespace {

constexpr int kVoters = 20;
constexpr int kAgreeFifths = 2;
constexpr std::array<std::pair<int, int>, 8> kDirections{
    {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}}};

int color_difference(const ColorPlanes& picture, std::size_t a, std::size_t b) {
  return std::abs(int(picture.r[a]) - int(picture.r[b])) +
         std::abs(int(picture.g[a]) - int(picture.g[b])) +
         std::abs(int(picture.b[a]) - int(picture.b[b]));
}

// The most frequent disparity, rounded, in the vertical arms of a pixel's cross and the horizontal
// arms of each pixel there; kNoDisparity if too few pixels agree.
float vote_in_cross(const Image<Arms>& arms, const Image<float>& disparity,
                    const Image<InvalidReason>& invalid_reasons, int x, int y, int first,
                    std::vector<int>& votes) {
  std::ranges::fill(votes, 0);
  int voters = 0;
  const Arms& own = arms.at(x, y);
  const auto reach = [](int arm) { return std::min(arm, kVoteReach); };
  for (int row = y - reach(own.up); row <= y + reach(own.down); ++row) {
    const Arms& across = arms.at(x, row);
    for (int column = x - reach(across.left); column <= x + reach(across.right); ++column) {
      if (invalid_reasons.at(column, row) != InvalidReason::kNone) continue;
      const int number = int(std::floor(disparity.at(column, row) + 0.5f)) - first;
      ++votes[std::size_t(std::clamp(number, 0, int(votes.size()) - 1))];
      ++voters;
    }
  }
  const auto most = std::ranges::max_element(votes);
  if (voters < kVoters || 5 * *most < kAgreeFifths * voters) return kNoDisparity;
  return float(first + int(most - votes.begin()));
}

float fill_from_neighbours(const ColorPlanes& picture, const Image<float>& disparity,
                           const Image<InvalidReason>& invalid_reasons, int x, int y) {
  float farthest = kNoDisparity, second = kNoDisparity;  // the two smallest disparities found
  float likest = kNoDisparity;
  int least = 766;  // more than any sum of differences of three channels
  const std::size_t own = disparity.index(x, y);
  for (const auto& [dx, dy] : kDirections) {
    int column = x + dx, row = y + dy;
    const auto is_inside = [&] {
      return column >= 0 && row >= 0 && column < disparity.width && row < disparity.height;
    };
    while (is_inside() && invalid_reasons.at(column, row) != InvalidReason::kNone)
      column += dx, row += dy;
    if (!is_inside()) continue;
    const std::size_t at = disparity.index(column, row);
    const float value = disparity.pixels[at];
    second = std::min(second, std::max(farthest, value));
    farthest = std::min(farthest, value);
    const int difference = color_difference(picture, own, at);
    if (difference < least) least = difference, likest = value;
  }
  if (invalid_reasons.pixels[own] == InvalidReason::kMismatched) return likest;
  return std::isfinite(second) ? second : farthest;
}

}  // namespace

void fill_by_vote(const Image<Arms>& arms, int first, int count, int rounds,
                  Image<float>& disparity, Image<InvalidReason>& invalid_reasons) {
  for (int round = 0; round < rounds; ++round) {
    const Image<float> before = disparity;
    const Image<InvalidReason> invalid = invalid_reasons;
    tbb::parallel_for(0, disparity.height, [&](int y) {
      std::vector<int> votes(static_cast<std::size_t>(count));
      for (int x = 0; x < disparity.width; ++x) {
        if (invalid.at(x, y) == InvalidReason::kNone) continue;
        const float value = vote_in_cross(arms, before, invalid, x, y, first, votes);
        if (!std::isfinite(value)) continue;
        disparity.at(x, y) = value;
        invalid_reasons.at(x, y) = InvalidReason::kNone;
      }
    });
  }
}

void fill_holes(const ColorPlanes& picture, Image<float>& disparity,
                const Image<InvalidReason>& invalid_reasons) {
  const Image<float> before = disparity;
  tbb::parallel_for(0, disparity.height, [&](int y) {
    for (int x = 0; x < disparity.width; ++x) {
      if (invalid_reasons.at(x, y) == InvalidReason::kNone) continue;
      disparity.at(x, y) = fill_from_neighbours(picture, before, invalid_reasons, x, y);
    }
  });
}

}  // namespace glassbox::views
