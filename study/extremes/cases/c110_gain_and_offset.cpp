#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/matching_pair.h"

namespace glassbox::study {
namespace c110 {

constexpr int kDisparity = 9;

// The right picture, either unchanged or with gain, offset and darker edges. The noise is so dark
// that no changed grey value is above 255.
Image<Rgba8> right_picture(const Image<Rgba8>& left, bool changed) {
  Image<Rgba8> right = moved_left(left, kDisparity, 111, 127);
  if (!changed) return right;
  for (int y = 0; y < right.height; ++y) {
    for (int x = 0; x < right.width; ++x) {
      // The distance from the picture's middle, as a percentage of half the width.
      const int from_middle = std::abs(2 * x - right.width) * 100 / right.width;
      Rgba8& pixel = right.at(x, y);
      const int grey = (pixel.g * 13 / 10 + 40) * (1000 - from_middle) / 1000;
      pixel.r = pixel.g = pixel.b = std::uint8_t(grey);
    }
  }
  return right;
}

// The percentage of wrong pixels among those that the right picture also shows.
double wrong_percent(const views::MatchSettings& settings, bool changed) {
  const Image<Rgba8> left = grey_noise(120, 60, 110, 127);
  const views::DenseMatch match = matched(left, right_picture(left, changed), settings);
  int wrong = 0, all = 0;
  for (int y = 4; y < left.height - 4; ++y) {
    for (int x = 24; x < left.width - 4; ++x) {
      wrong += !(std::abs(match.disparity.at(x, y) - kDisparity) <= 1);
      ++all;
    }
  }
  return 100.0 * wrong / all;
}

Outcome measure_error(views::MatchingCost cost, int window) {
  views::MatchSettings settings = plain_settings("winner", {0, 20});
  settings.cost = cost;
  settings.window = window;
  settings.left_right.reset();
  const double before = wrong_percent(settings, false), after = wrong_percent(settings, true);
  return {
      after,
      0.5,
      {},
      fmt::format("{:.3g} % of the pixels wrong, and {:.3g} % before the change", after, before)};
}

}  // namespace c110

ExtremeCase c110_gain_and_offset() {
  using namespace c110;
  using views::MatchingCost;
  return {
      .id = "C-110",
      .name = "Another gain, offset and vignette",
      .construction =
          "noise of 0 to 127 at disparity 9; the right picture times 1.3, plus 40, and a tenth "
          "darker at its sides",
      .stage = "matching",
      .right_answer =
          "at most 0.5 % of the pixels are wrong, because census compares each pixel with its "
          "neighbours, and a darker one stays darker",
      .unit = "per cent",
      .oracle = Oracle::kProperty,
      .ours = {"census", [] { return measure_error(MatchingCost::kCensus, 3); }},
      .naive = {"absolute differences", [] { return measure_error(MatchingCost::kSad, 3); }},
      .mutants = {{"squared differences", [] { return measure_error(MatchingCost::kSsd, 3); }},
                  {"absolute differences over a larger square",
                   [] { return measure_error(MatchingCost::kSad, 5); }}},
      .not_drawn = "the case computes disparities from given pictures; no engine draws them",
  };
}

}  // namespace glassbox::study
