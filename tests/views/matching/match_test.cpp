// C-110, C-111, C-113, D-20: the results of a whole match, and the pictures and settings that are
// refused.
#include <tests/support/catch.h>

#include <cmath>

#include "tests/views/matching/known_pairs.h"
#include "views/matching/calibration.h"
#include "views/matching/disparity_errors.h"
#include "views/matching/match.h"
#include "views/matching/winner.h"

namespace glassbox::views {
namespace {

MatchSettings method(const char* name, DisparityRange range) {
  MatchSettings settings = *settings_named(name);
  settings.range = range;
  return settings;
}

DenseMatch matched(const Image<Rgba8>& left, const Image<Rgba8>& right,
                   const MatchSettings& settings) {
  auto match = match_pictures(left, right, settings);
  REQUIRE(match);
  return std::move(*match);
}

// Counts only pixels whose windows are inside the part that both pictures show. No window reaches
// further than kReach px: five for a square of 11, or four for a census word and one for a square
// of 3; and one for the median.
constexpr int kReach = 6;

double wrong_share(const Image<float>& disparity, int d) {
  int wrong = 0, all = 0;
  for (int y = 0; y < disparity.height; ++y) {
    for (int x = std::max(0, d) + kReach;
         x < std::min(disparity.width, disparity.width + d) - kReach; ++x) {
      wrong += !(std::abs(disparity.at(x, y) - float(d)) <= 0.5f);
      ++all;
    }
  }
  return double(wrong) / all;
}

TEST_CASE("D-20: the same bytes for every instruction set and number of threads") {
  const Image<Rgba8> left = noise(71, 150, 5), right = moved_left(left, 6, 6);
  for (auto& [name, settings] : settings_of_every_path({-3, 33})) {
    settings.target = Target::kScalar;
    settings.threads = 1;
    // The single sweep uses three bands here.
    const DenseMatch reference = matched(left, right, settings);
    for (const Target target : available_targets()) {
      for (const int threads : {1, 2, 5, 0}) {
        settings.target = target;
        settings.threads = threads;
        const DenseMatch match = matched(left, right, settings);
        INFO(name << ", " << name_of(target) << ", " << threads << " threads");
        CHECK(match.disparity == reference.disparity);
        CHECK(match.confidence == reference.confidence);
        CHECK(match.invalid_reasons == reference.invalid_reasons);
      }
    }
  }
}

TEST_CASE("S2-04: a wall of noise stands where it was put, before the window and behind it") {
  const Image<Rgba8> left = noise(90, 40, 7);
  for (const int d : {0, 11, -7}) {
    const Image<Rgba8> right = moved_left(left, d, 8);
    for (const auto& [name, settings] : settings_of_every_path({-12, 20})) {
      INFO(name << ", disparity " << d);
      const DenseMatch match = matched(left, right, settings);
      CHECK(wrong_share(match.disparity, d) == 0);
    }
  }
}

TEST_CASE("S2-04: the part of a pixel is where the two lines through three costs meet") {
  for (const double best : {4.0, 4.3, 4.5, 7.8}) {
    CostVolume costs(30, 1, -1, 12);
    for (int x = 0; x < costs.width; ++x) {
      std::fill_n(costs.at(x, 0), costs.stride, kNeverCost);
      for (int i = 0; i < costs.count; ++i) {
        costs.at(x, 0)[i] = std::uint16_t(100 * std::abs(i - 1 - best) + 0.5);
      }
    }
    const DisparityMaps winners = find_winners(costs, nullptr, true, best_target());
    INFO(best);
    // Costs are rounded to a hundredth of what a pixel changes: by half of that in each of the two
    // lines.
    CHECK(std::abs(double(winners.left.at(20, 0)) - best) <= 0.01);
    // Neighbours in the same valley are not rivals; the nearest rivals are 2 px away.
    CHECK(winners.confidence.at(20, 0) > 0.5f);
  }
}

TEST_CASE("C-110: gain and offset are nothing to census and ZNCC, and the end of SAD") {
  Image<Rgba8> left = noise(90, 60, 9);
  for (Rgba8& pixel : left.pixels) {
    // Grey, and dark enough that no value is clipped.
    pixel.r = pixel.g = pixel.b = std::uint8_t(pixel.r / 2);
  }
  Image<Rgba8> right = moved_left(left, 9, 10);
  for (Rgba8& pixel : right.pixels) {
    pixel.r = pixel.g = pixel.b = std::uint8_t(std::min(255, pixel.r * 13 / 10 + 40));
  }
  const auto wrong = [&](MatchingCost cost, int window) {
    MatchSettings settings = method("winner", {0, 20});
    settings.cost = cost;
    settings.window = window;
    settings.left_right.reset();
    settings.fill = settings.median = false;
    return wrong_share(matched(left, right, settings).disparity, 9);
  };
  const double zncc = wrong(MatchingCost::kZncc, 7), census = wrong(MatchingCost::kCensus, 3);
  CHECK(zncc == 0);
  CHECK(census == 0);
  CHECK(wrong(MatchingCost::kSad, 3) > 0.1);
}

TEST_CASE("C-111: a period and a blank wall have no clear winner") {
  Image<Rgba8> stripes(80, 20), blank(80, 20, {90, 90, 90, 255});
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 80; ++x) {
      const auto value = std::uint8_t(x % 8 * 30);
      stripes.at(x, y) = {value, value, value, 255};
    }
  }
  MatchSettings settings = method("winner", {0, 31});
  settings.confidence = 0.1f;
  settings.fill = false;
  for (const Image<Rgba8>& wall : {stripes, blank}) {
    const DenseMatch match = matched(wall, wall, settings);
    // From column 40 on the range contains four periods.
    for (int x = 40; x < 70; ++x) CHECK(match.disparity.at(x, 10) == kNoDisparity);
  }
  const Image<Rgba8> clear = noise(80, 20, 11);
  const DenseMatch match = matched(clear, clear, settings);
  for (int x = 40; x < 70; ++x) CHECK(match.disparity.at(x, 10) == 0);
}

TEST_CASE("C-113: what the range or the picture does not hold is invalid, not clamped") {
  const Image<Rgba8> left = noise(60, 30, 12), right = moved_left(left, 4, 13);
  MatchSettings settings = method("default", {10, 20});
  settings.fill = settings.median = false;
  const DenseMatch match = matched(left, right, settings);
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 10; ++x) {
      CHECK(match.disparity.at(x, y) == kNoDisparity);
      CHECK(match.invalid_reasons.at(x, y) == InvalidReason::kOutside);
    }
    for (int x = 0; x < 60; ++x) {
      const float d = match.disparity.at(x, y);
      CHECK((d == kNoDisparity || (d >= 9.5f && d <= 20.5f && float(x) - d > -1)));
    }
  }
}

TEST_CASE("what cannot be matched is refused before anything is allocated") {
  const Image<Rgba8> some(20, 10), other(21, 10), single(1, 1);
  const auto cause = [](const Image<Rgba8>& left, const Image<Rgba8>& right,
                        const MatchSettings& settings, std::uint64_t bytes = 1u << 30) {
    const auto match = match_pictures(left, right, settings, bytes);
    REQUIRE_FALSE(match);
    return match.error().message();
  };
  CHECK(cause(some, other, {}).find("20 x 10 and 21 x 10") != std::string::npos);
  CHECK(cause(single, single, {}).find("1 x 1") != std::string::npos);
  CHECK(cause(some, some, method("default", {3, 2})).find("empty range") != std::string::npos);
  CHECK(cause(some, some, method("default", {20, 30})).find("no pixel has a partner") !=
        std::string::npos);
  // 20 x 10 pixels with 16032 disparities of six bytes each.
  CHECK(bytes_of_match(20, 10, method("default", {0, 16000})) == 20u * 10 * 16032 * 6);
  CHECK(cause(some, some, method("default", {0, 16000}), 19'000'000).find("18 MB") !=
        std::string::npos);
}

TEST_CASE("C-107, C-109, C-114: depth adds the offset, and needs a baseline") {
  Image<float> disparity(4, 1);
  disparity.pixels = {100, 0, -40, kNoDisparity};
  const Calibration motorcycle{994.978, 193.001, 31.086};
  const Image<float> depths = depths_of(disparity, motorcycle);
  // The rounding of a float: 2^-24 of about 1500 mm.
  CHECK(std::abs(double(depths.pixels[0]) - 994.978 * 193.001 / 131.086) < 1e-4);
  CHECK(std::abs(double(depths.pixels[1]) - 994.978 * 193.001 / 31.086) < 5e-4);
  CHECK(std::isinf(depths.pixels[2]));
  CHECK(std::isinf(depths.pixels[3]));
  CHECK(check_calibration(motorcycle));
  CHECK_FALSE(check_calibration({994.978, 0, 31.086}));
  CHECK_FALSE(check_calibration({std::nan(""), 1, 0}));
  // The product F B is 0 or infinite.
  for (const double size : {1e-300, 1e300}) {
    const auto legal = check_calibration({size, size, 0});
    REQUIRE_FALSE(legal);
    CHECK(legal.error().cause.find("do not fit into 32-bit floats") != std::string::npos);
  }
  // Depths that are 0 or infinite as floats are invalid.
  for (const Calibration& steep : {Calibration{1e-25, 1, 1e25}, Calibration{1, 1e30, 1e-10}}) {
    CHECK(std::isinf(depths_of(Image<float>(1, 1, 0), steep).pixels[0]));
  }
  // The right picture's camera is to the left of the other.
  const Image<float> swapped = depths_of(disparity, {994.978, -193.001, -31.086});
  CHECK(std::isinf(swapped.pixels[0]));
  CHECK(std::abs(double(swapped.pixels[2]) - 994.978 * 193.001 / 71.086) < 5e-4);
}

}  // namespace
}  // namespace glassbox::views
