#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/matching_pair.h"
#include "study/naive/matching.h"
#include "views/matching/winner.h"

namespace glassbox::study {
namespace c113 {

using Matcher = Image<float> (*)(const Image<Rgba8>& left, const Image<Rgba8>& right,
                                 const views::DisparityRange& range);

Image<float> ours(const Image<Rgba8>& left, const Image<Rgba8>& right,
                  const views::DisparityRange& range) {
  return matched(left, right, plain_settings("default", range)).disparity;
}
Image<float> filled(const Image<Rgba8>& left, const Image<Rgba8>& right,
                    const views::DisparityRange& range) {
  views::MatchSettings settings = plain_settings("default", range);
  settings.fill = true;
  return matched(left, right, settings).disparity;
}
Image<float> match_positive_disparities(const Image<Rgba8>& left, const Image<Rgba8>& right,
                                        const views::DisparityRange& range) {
  return ours(left, right, {std::max(0, range.first), range.last});
}

// Counts three kinds of errors: a disparity for a pixel that has no match within the range in the
// right picture; a disparity that is outside the range by more than half a pixel, which subpixel
// refinement may add; and a pixel of the wall with disparity -4 for which -4 is not found.
Outcome measure_error(Matcher matcher) {
  constexpr int kWidth = 60, kHeight = 30;
  const Image<Rgba8> left = grey_noise(kWidth, kHeight, 113);
  int wrong = 0;
  const views::DisparityRange far{10, 20}, around{-8, 8};
  const Image<float> beside = matcher(left, moved_left(left, 12, 1), far);
  const Image<float> behind = matcher(left, moved_left(left, -4, 2), around);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const float d = beside.at(x, y);
      const bool none = d == views::kNoDisparity;
      wrong += x < far.first ? !none : !none && !(d >= 9.5f && d <= 20.5f && float(x) - d > -1);
      if (y >= 4 && y < kHeight - 4 && x >= 12 && x < kWidth - 12)
        wrong += !(std::abs(behind.at(x, y) + 4) <= 0.5f);
    }
  }
  return wrong_count_outcome(wrong, kWidth * kHeight, "pixels are wrong");
}

}  // namespace c113

ExtremeCase c113_beside_the_picture() {
  using namespace c113;
  return {
      .id = "C-113",
      .name = "No match in the range or in the picture",
      .construction =
          "a wall at disparity 12, searched from 10 to 20; one at -4, searched from -8 to 8",
      .stage = "matching",
      .right_answer =
          "pixels of the first ten columns, whose matches are outside of the right picture, have "
          "no disparity; negative disparities are found",
      .unit = "pixels",
      .oracle = Oracle::kProperty,
      .ours = {"a pixel is invalid where no match is possible", [] { return measure_error(ours); }},
      .naive = {"positions outside the picture are clamped to its edge",
                [] { return measure_error(naive::match_clamped); }},
      .mutants = {{"holes are filled", [] { return measure_error(filled); }},
                  {"only disparities of 0 and above are searched",
                   [] { return measure_error(match_positive_disparities); }}},
      .not_drawn = "the case computes disparities from given pictures; no engine draws them",
  };
}

}  // namespace glassbox::study
