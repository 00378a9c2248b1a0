// S2-04: every cost and average, compared with its definition, written out.
#include <tests/support/catch.h>

#include <bit>
#include <cmath>
#include <cstdlib>

#include "tests/views/matching/known_pairs.h"
#include "views/matching/cost_aggregation.h"
#include "views/matching/costs.h"

namespace glassbox::views {
namespace {

constexpr int kAcross = 37, kRows = 11;

// The picture with a sixth of its contrast in the left half, so that some neighbours are alike and
// some are not.
ColorPlanes half_faint(Image<Rgba8> image) {
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width / 2; ++x) {
      Rgba8& pixel = image.at(x, y);
      for (std::uint8_t* channel : {&pixel.r, &pixel.g, &pixel.b})
        *channel = std::uint8_t(100 + *channel / 6);
    }
  }
  return color_planes(image);
}

struct NoisePair {
  ColorPlanes left = half_faint(noise(kAcross, kRows, 3)),
              right = half_faint(noise(kAcross, kRows, 4));
};

int grey(const ColorPlanes& planes, int x, int y) {
  x = std::clamp(x, 0, kAcross - 1);
  y = std::clamp(y, 0, kRows - 1);
  return planes.grey[std::size_t(y * kAcross + x)];
}

int color_difference(const NoisePair& pair, int x, int right_x, int y) {
  const auto a = std::size_t(y * kAcross + x), b = std::size_t(y * kAcross + right_x);
  return std::abs(pair.left.r[a] - pair.right.r[b]) + std::abs(pair.left.g[a] - pair.right.g[b]) +
         std::abs(pair.left.b[a] - pair.right.b[b]);
}

bool is_alike(const ColorPlanes& planes, int x, int y, int dx, int dy) {
  const auto at = [&](const CacheAlignedVector<std::uint8_t>& plane, int column, int row) {
    column = std::clamp(column, 0, kAcross - 1), row = std::clamp(row, 0, kRows - 1);
    return int(plane[std::size_t(row * kAcross + column)]);
  };
  const auto is_near = [&](const CacheAlignedVector<std::uint8_t>& plane) {
    return std::abs(at(plane, x + dx, y + dy) - at(plane, x, y)) <= 30;
  };
  return is_near(planes.r) && is_near(planes.g) && is_near(planes.b);
}

// Calls one(dx, dy) for each of the 32 neighbours of the census.
template <class One>
void for_neighbours(const One& one) {
  for (int dy = -2; dy <= 2; ++dy) {
    for (int dx = -3; dx <= 3; ++dx) {
      if (dy != 0 || (dx != 0 && std::abs(dx) != 3)) one(dx, dy);
    }
  }
}

int count_alike(const ColorPlanes& planes, int x, int y) {
  int count = 0;
  for_neighbours([&](int dx, int dy) { count += is_alike(planes, x, y, dx, dy); });
  return count;
}

// How many census bits differ, of all neighbours or (`of_alike`) only of those that resemble their
// centres in both pictures; a centre with fewer than 12 such neighbours uses all.
int bits_that_differ(const NoisePair& pair, int x, int right_x, int y, bool of_alike = false) {
  int bits = 0;
  const bool all_left = !of_alike || count_alike(pair.left, x, y) < 12,
             all_right = !of_alike || count_alike(pair.right, right_x, y) < 12;
  for_neighbours([&](int dx, int dy) {
    const bool left = grey(pair.left, x + dx, y + dy) < grey(pair.left, x, y);
    const bool right = grey(pair.right, right_x + dx, y + dy) < grey(pair.right, right_x, y);
    const bool counts = (all_left || is_alike(pair.left, x, y, dx, dy)) &&
                        (all_right || is_alike(pair.right, right_x, y, dx, dy));
    bits += counts && left != right;
  });
  return bits;
}

// The correlation over the part of the window that is in both pictures.
double window_correlation(const NoisePair& pair, int x, int right_x, int y, int radius,
                          bool centred) {
  double n = 0, a = 0, b = 0, aa = 0, bb = 0, ab = 0;
  for (int dy = -radius; dy <= radius; ++dy) {
    for (int dx = -radius; dx <= radius; ++dx) {
      const auto inside = [&](int column) { return column + dx >= 0 && column + dx < kAcross; };
      if (!inside(x) || !inside(right_x) || y + dy < 0 || y + dy >= kRows) continue;
      const double left = grey(pair.left, x + dx, y + dy);
      const double right = grey(pair.right, right_x + dx, y + dy);
      n += 1, a += left, b += right, aa += left * left, bb += right * right, ab += left * right;
    }
  }
  if (!centred) return ab / std::sqrt(aa * bb);
  return (ab - a * b / n) / std::sqrt((aa - a * a / n) * (bb - b * b / n));
}

double defined(const NoisePair& pair, const MatchSettings& settings, int x, int right_x, int y) {
  const int difference = grey(pair.left, x, y) - grey(pair.right, right_x, y);
  switch (settings.cost) {
    case MatchingCost::kSad:
      return 6 * std::abs(difference);
    case MatchingCost::kSsd:
      return (difference * difference + 16) / 32;
    case MatchingCost::kNcc:
    case MatchingCost::kZncc: {
      const bool centred = settings.cost == MatchingCost::kZncc;
      return (1 - window_correlation(pair, x, right_x, y, settings.window / 2, centred)) * 1023;
    }
    case MatchingCost::kCensus:
      return 16 * bits_that_differ(pair, x, right_x, y);
    case MatchingCost::kAdCensus:
      break;
  }
  return 16 * std::min(bits_that_differ(pair, x, right_x, y, true), 30) +
         4 * std::min(color_difference(pair, x, right_x, y), 60);
}

TEST_CASE(
    "S2-04: every cost is its definition, on every instruction set; beside the picture nothing "
    "matches") {
  const NoisePair pair;
  for (const Target target : available_targets()) {
    for (const MatchingCost cost :
         {MatchingCost::kSad, MatchingCost::kSsd, MatchingCost::kNcc, MatchingCost::kZncc,
          MatchingCost::kCensus, MatchingCost::kAdCensus}) {
      MatchSettings settings;
      settings.range = {-5, 40};
      settings.cost = cost;
      settings.window = 5;
      settings.target = target;
      const CostVolume volume = pixel_costs(pair.left, pair.right, settings);
      INFO(name_of(target) << ", " << name_of(cost));
      for (int y = 0; y < kRows; ++y) {
        for (int x = 0; x < kAcross; ++x) {
          for (int i = 0; i < volume.count; ++i) {
            const int right_x = x - (i - 5);
            INFO("pixel " << x << ", " << y << ", disparity " << i - 5);
            const bool inside = right_x >= 0 && right_x < kAcross;
            const double value =
                inside ? defined(pair, settings, x, right_x, y) : double(kHighestCost);
            // Half a unit for the rounding; sums in another order differ by about 1e-13.
            REQUIRE(std::abs(volume.at(x, y)[i] - value) <= 0.5 + 1e-6);
            REQUIRE((i >= volume.from(x) && i < volume.to(x)) == inside);
          }
        }
      }
    }
  }
}

TEST_CASE("S2-04: the average of a square is the mean of the rows' means, to a rounding each") {
  const NoisePair pair;
  MatchSettings settings;
  settings.range = {0, 7};
  settings.cost = MatchingCost::kSsd;
  const CostVolume single = pixel_costs(pair.left, pair.right, settings);
  for (const Target target : available_targets()) {
    CostVolume averaged = single;
    average_costs(averaged, square_arms(kAcross, kRows, 2), AggregationOrder::kRows, target);
    for (int y = 0; y < kRows; ++y) {
      for (int x = 0; x < kAcross; ++x) {
        const int i = (x + y) % 8;
        double sum = 0;
        int count = 0;
        for (int row = std::max(0, y - 2); row <= std::min(kRows - 1, y + 2); ++row) {
          for (int column = std::max(0, x - 2); column <= std::min(kAcross - 1, x + 2); ++column) {
            sum += single.at(column, row)[i];
            ++count;
          }
        }
        INFO(name_of(target) << ": pixel " << x << ", " << y);
        // Half a unit for each of two roundings; the inverse's rounding is 2^-24 of 65535.
        REQUIRE(std::abs(averaged.at(x, y)[i] - sum / count) <= 1.01);
      }
    }
  }
}

TEST_CASE("arms stop where the colour changes") {
  Image<Rgba8> image(50, 3, {100, 100, 100, 255});
  for (int y = 0; y < 3; ++y) {
    for (int x = 20; x < 50; ++x) image.at(x, y) = {100, 121, 100, 255};
  }
  const Image<Arms> arms = adaptive_arms(color_planes(image));
  CHECK(int(arms.at(10, 1).right) == 9);
  CHECK(int(arms.at(10, 1).left) == 10);
  CHECK(int(arms.at(20, 1).left) == 0);
  CHECK(int(arms.at(20, 1).right) == 29);
  CHECK(int(arms.at(20, 1).up) == 1);
}

}  // namespace
}  // namespace glassbox::views
