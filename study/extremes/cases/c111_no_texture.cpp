#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/matching_pair.h"
#include "views/matching/winner.h"

namespace glassbox::study {
namespace c111 {

constexpr int kWidth = 80, kHeight = 20;

// A wall with stripes that repeat every 8 px and noise from 0 to 8, or a blank wall.
Image<Rgba8> wall(bool striped, std::uint64_t seed) {
  Image<Rgba8> picture = grey_noise(kWidth, kHeight, seed, 8);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      Rgba8& pixel = picture.at(x, y);
      const int grey = striped ? pixel.g + x % 8 * 30 : 90;
      pixel.r = pixel.g = pixel.b = std::uint8_t(grey);
    }
  }
  return picture;
}

// Counts the pixels of walls that get an answer although they should not, and the pixels of clear
// noise that get none. Only columns 40 to 69 are counted, where every disparity of the range is
// possible.
Outcome measure_error(const views::MatchSettings& settings) {
  int guessed = 0, silent = 0;
  const auto answered = [&](const Image<Rgba8>& left, const Image<Rgba8>& right) {
    const views::DenseMatch match = matched(left, right, settings);
    int count = 0;
    for (int x = 40; x < 70; ++x) count += match.disparity.at(x, 10) != views::kNoDisparity;
    return count;
  };
  for (const bool striped : {true, false}) guessed += answered(wall(striped, 1), wall(striped, 2));
  const Image<Rgba8> clear = grey_noise(kWidth, kHeight, 3, 254);
  Image<Rgba8> noisy = clear;
  for (std::size_t i = 0; i < noisy.pixels.size(); i += 2) {
    Rgba8& pixel = noisy.pixels[i];
    pixel.r = pixel.g = pixel.b = std::uint8_t(pixel.g + 1);
  }
  silent = 30 - answered(clear, noisy);
  return must_be_zero(
      guessed + silent,
      fmt::format("{} of 60 ambiguous pixels got a disparity, and {} of 30 clear pixels got none",
                  guessed, silent));
}

views::MatchSettings by_confidence(float least) {
  views::MatchSettings settings = plain_settings("winner", {0, 31});
  settings.confidence = least;
  return settings;
}

}  // namespace c111

ExtremeCase c111_no_texture() {
  using namespace c111;
  return {
      .id = "C-111",
      .name = "A blank wall and a repeated pattern",
      .construction =
          "stripes with a period of 8 px and a blank wall, each with noise of one code; 32 "
          "disparities, which are four periods",
      .stage = "matching",
      .right_answer =
          "the ambiguous pixels get no disparity, because the second-lowest cost (neighbours "
          "excluded) differs from the lowest one only by noise, which the mean of 121 pixels "
          "divides by 11; a pair of random noise gets a disparity everywhere",
      .unit = "pixels",
      .oracle = Oracle::kProperty,
      .ours = {"peak ratio of at least 1/4", [] { return measure_error(by_confidence(0.25f)); }},
      .naive = {"the disparity with the lowest cost, without a test",
                [] { return measure_error(by_confidence(0)); }},
      .mutants = {{"only exactly equal costs count as ambiguous",
                   [] { return measure_error(by_confidence(1e-6f)); }},
                  {"peak ratio of 1", [] { return measure_error(by_confidence(0.9999f)); }}},
      .not_drawn = "the case computes disparities from given pictures; no engine draws them",
  };
}

}  // namespace glassbox::study
