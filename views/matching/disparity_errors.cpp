#include "views/matching/disparity_errors.h"

#include <algorithm>
#include <cmath>

#include "views/matching/winner.h"

namespace glassbox::views {

namespace {

constexpr float kSame = 1;  // px
constexpr double kGood = kBadAt[1];
constexpr float kJump = 2;    // px
constexpr int kNearJump = 4;  // px

double percent(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : 100 * double(part) / double(whole);
}

// The column of the corresponding pixel in the right picture; -1 if it would be outside.
int column_of(int x, float disparity, int width) {
  if (!std::isfinite(disparity)) return -1;
  const float place = std::floor(float(x) - disparity + 0.5f);
  return place >= 0 && place < float(width) ? int(place) : -1;
}

}  // namespace

Image<float> known_disparities(Image<float> stored, float scale) {
  for (float& value : stored.pixels) {
    value = std::isfinite(value) && value != 0 ? value / scale : kNoDisparity;
  }
  return stored;
}

Image<std::uint8_t> visible_by_reprojection(const Image<float>& disparity) {
  Image<std::uint8_t> visible(disparity.width, disparity.height, 0);
  std::vector<float> nearest(std::size_t(disparity.width));
  for (int y = 0; y < disparity.height; ++y) {
    std::ranges::fill(nearest, -kNoDisparity);
    const auto for_each = [&](const auto& one) {
      for (int x = 0; x < disparity.width; ++x) {
        const int column = column_of(x, disparity.at(x, y), disparity.width);
        if (column >= 0) one(x, nearest[std::size_t(column)]);
      }
    };
    for_each([&](int x, float& there) { there = std::max(there, disparity.at(x, y)); });
    for_each(
        [&](int x, const float& there) { visible.at(x, y) = disparity.at(x, y) >= there - kSame; });
  }
  return visible;
}

Image<std::uint8_t> visible_by_right_truth(const Image<float>& left, const Image<float>& right) {
  Image<std::uint8_t> visible(left.width, left.height, 0);
  for (int y = 0; y < left.height; ++y) {
    for (int x = 0; x < left.width; ++x) {
      const int column = column_of(x, left.at(x, y), left.width);
      if (column < 0) continue;
      visible.at(x, y) = std::abs(right.at(column, y) - left.at(x, y)) <= kSame;
    }
  }
  return visible;
}

Image<std::uint8_t> near_discontinuity(const Image<float>& disparity) {
  const int width = disparity.width, height = disparity.height;
  Image<std::uint8_t> near(width, height, 0);
  const auto mark_around = [&](int x, int y) {
    for (int row = std::max(y - kNearJump, 0); row <= std::min(y + kNearJump, height - 1); ++row) {
      const int from = std::max(x - kNearJump, 0), to = std::min(x + kNearJump, width - 1);
      std::fill(&near.at(from, row), &near.at(from, row) + (to - from + 1), std::uint8_t(1));
    }
  };
  // Unknown disparities are infinite: they are not subtracted, and no jump is reported there.
  const auto jumps = [&](std::size_t a, std::size_t b) {
    const float one = disparity.pixels[a], other = disparity.pixels[b];
    return std::isfinite(one) && std::isfinite(other) && std::abs(one - other) > kJump;
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t at = disparity.index(x, y);
      if (x + 1 < width && jumps(at, at + 1)) mark_around(x, y), mark_around(x + 1, y);
      if (y + 1 < height && jumps(at, disparity.index(x, y + 1))) {
        mark_around(x, y), mark_around(x, y + 1);
      }
    }
  }
  return near;
}

DisparityErrors disparity_errors(const Image<float>& disparity, const Image<float>& truth,
                                 const Image<std::uint8_t>* mask) {
  DisparityErrors errors;
  std::array<std::uint64_t, kBadAt.size()> bad{};
  double squares = 0, good_squares = 0;
  for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
    if (!std::isfinite(truth.pixels[i]) || (mask && mask->pixels[i] == 0)) continue;
    ++errors.known;
    if (!std::isfinite(disparity.pixels[i])) continue;
    ++errors.answered;
    const double off = std::abs(double(disparity.pixels[i]) - double(truth.pixels[i]));
    squares += off * off;
    if (off <= kGood) good_squares += off * off;
    for (std::size_t k = 0; k < bad.size(); ++k) bad[k] += off > kBadAt[k];
  }
  const std::uint64_t silent = errors.known - errors.answered;
  for (std::size_t k = 0; k < bad.size(); ++k) {
    errors.bad_percent[k] = percent(bad[k] + silent, errors.known);
    errors.bad_of_answered[k] = percent(bad[k], errors.answered);
  }
  errors.rms = errors.answered == 0 ? 0 : std::sqrt(squares / double(errors.answered));
  const std::uint64_t good = errors.answered - bad[1];
  errors.rms_good = good == 0 ? 0 : std::sqrt(good_squares / double(good));
  errors.density_percent = percent(errors.answered, errors.known);
  return errors;
}

}  // namespace glassbox::views
