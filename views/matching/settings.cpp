#include "views/matching/settings.h"

#include <array>
#include <cstdint>

#include <fmt/format.h>

namespace glassbox::views {

namespace {

constexpr std::array<std::string_view, 6> kCosts{"sad",  "ssd",    "ncc",
                                                 "zncc", "census", "ad-census"};
constexpr int kFarthest = 16384;  // px: no picture that can be read is wider

}  // namespace

std::string_view name_of(MatchingCost cost) {
  return kCosts[std::size_t(cost)];
}

std::optional<MatchSettings> settings_named(std::string_view name) {
  MatchSettings settings;
  if (name == "default") return settings;
  if (name == "fast") {
    settings.cost = MatchingCost::kCensus;
    settings.adaptive = 0;
    settings.paths = 4;
    settings.single_sweep = true;
    settings.vote = false;
    return settings;
  }
  if (name == "winner") {
    settings.cost = MatchingCost::kSad;
    settings.window = 11;
    settings.adaptive = 0;
    settings.paths = 0;
    settings.vote = false;
    return settings;
  }
  return std::nullopt;
}

Result<void> check_settings(const MatchSettings& settings) {
  const DisparityRange& range = settings.range;
  if (range.last < range.first) {
    return fail("--range", fmt::format("{},{} is an empty range", range.first, range.last),
                "give the least and then the greatest disparity, in pixels");
  }
  if (range.first < -kFarthest || range.last > kFarthest) {
    return fail("--range",
                fmt::format("{},{} has disparities that are larger than any picture", range.first,
                            range.last),
                fmt::format("give disparities within {} pixels", kFarthest));
  }
  if (settings.window < 1 || settings.window > 15 || settings.window % 2 == 0) {
    return fail("--cost-window", fmt::format("{} is not a window size", settings.window),
                "give an odd number from 1 to 15");
  }
  if (is_correlation(settings.cost) && settings.window == 1) {
    return fail("--cost-window", "the correlation of a single pixel is not defined",
                "give an odd number from 3 to 15 with ncc and zncc");
  }
  const int paths = settings.paths;
  if (paths != 0 && paths != 2 && paths != 4 && paths != 8 && paths != 16) {
    return fail("--paths", fmt::format("{} is not a possible number of paths", paths),
                "give 0, 2, 4, 8 or 16");
  }
  if (settings.adaptive < 0 || settings.adaptive > 4) {
    return fail("--adaptive", fmt::format("the number of rounds must not be {}", settings.adaptive),
                "give 0 to 4");
  }
  if (settings.left_right && (*settings.left_right < 0 || *settings.left_right > kFarthest)) {
    return fail("--left-right", fmt::format("{} is not a difference", *settings.left_right),
                "give a number of pixels, 0 or more");
  }
  if (!(settings.confidence >= 0 && settings.confidence <= 1)) {
    return fail("--confidence", fmt::format("{} is not a peak ratio", settings.confidence),
                "give 0 to 1");
  }
  if (settings.planes < 0 || settings.planes > 8) {
    return fail("--planes", fmt::format("the number of rounds must not be {}", settings.planes),
                "give 0 to 8");
  }
  if (settings.speckle < 0) {
    return fail("--speckle", fmt::format("{} is not a size", settings.speckle),
                "give a number of pixels, 0 or more");
  }
  return {};
}

}  // namespace glassbox::views
