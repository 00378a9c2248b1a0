// Measures the errors of a disparity map (S2-04).
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <glassbox/images/image.h>

namespace glassbox::views {

// The known right answers. A disparity that is not finite is unknown, and not an error (C-114).
struct StereoTruth {
  Image<float> disparity;          // px; kNoDisparity where unknown
  Image<std::uint8_t> is_visible;  // whether the right picture shows the point, too
};

// Converts stored disparities by the factor 1/scale; 0 and +inf mean unknown.
Image<float> known_disparities(Image<float> stored, float scale);

// Pixels whose point is visible in the right picture, as far as the left truth can tell: of the
// pixels that are mapped to one right pixel, the one with the greatest disparity is visible, and
// all others within one pixel of disparity.
Image<std::uint8_t> visible_by_reprojection(const Image<float>& disparity);
// The same with the right picture's own truth: the two disparities agree to within one pixel
// (Scharstein and Szeliski 2002).
Image<std::uint8_t> visible_by_right_truth(const Image<float>& left, const Image<float>& right);

// Pixels near a jump of depth, where windows contain two surfaces: within 4 px, across and down, of
// two neighbours that differ by more than 2 px (Scharstein and Szeliski 2002).
Image<std::uint8_t> near_discontinuity(const Image<float>& disparity);

inline constexpr std::array<double, 4> kBadAt{0.5, 1, 2, 4};  // px

struct DisparityErrors {
  std::uint64_t known = 0;     // pixels with a known truth
  std::uint64_t answered = 0;  // of these, pixels with a disparity
  // Share of the known ones with an error above each of kBadAt; no disparity counts as bad.
  std::array<double, 4> bad_percent{};
  std::array<double, 4> bad_of_answered{};  // the same, as a share of the answered ones
  double rms = 0;                           // px, over the answered ones
  double rms_good = 0;                      // px, over those with an error of at most 1 px
  double density_percent = 0;               // answered, as a share of the known ones
};

// For all pixels, or for those of a mask.
DisparityErrors disparity_errors(const Image<float>& disparity, const Image<float>& truth,
                                 const Image<std::uint8_t>* mask = nullptr);

}  // namespace glassbox::views
