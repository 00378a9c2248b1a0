// How wrong a disparity map is (SPEC S2-04).
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <glassbox/images/image.h>

namespace glassbox::views {

// What is known of the right answer. A truth that is not finite is unknown, and no error (C-114).
struct StereoTruth {
  Image<float> disparity;          // px; kNoDisparity where unknown
  Image<std::uint8_t> is_visible;  // whether the right picture shows the point
};

// Stored disparities times 1/scale; 0 and +inf mark what is unknown.
Image<float> known_disparities(Image<float> stored, float scale);

// Pixels whose point the right picture has, and nothing nearer before it, as far as the left truth knows: of pixels that fall on one
// right pixel the one of the greatest disparity is seen, and all others within a pixel of it.
Image<std::uint8_t> visible_by_reprojection(const Image<float>& disparity);
// The same by the right picture's own truth: the two agree to a pixel (Scharstein and Szeliski 2002).
Image<std::uint8_t> visible_by_right_truth(const Image<float>& left, const Image<float>& right);

// Pixels near a jump of depth, where windows see two surfaces: within 4 px, across and down, of two neighbours that differ by more than
// 2 px (Scharstein and Szeliski 2002).
Image<std::uint8_t> near_discontinuity(const Image<float>& disparity);

inline constexpr std::array<double, 4> kBadAt{0.5, 1, 2, 4};  // px

struct DisparityErrors {
  std::uint64_t known = 0;     // pixels of which there is truth
  std::uint64_t answered = 0;  // and a disparity
  std::array<double, 4>
      bad_percent{};  // further off than kBadAt, of the known; without a disparity counts as bad
  std::array<double, 4> bad_of_answered{};  // the same, of the answered
  double rms = 0;                           // px, of the answered
  double rms_good = 0;                      // px, of those that are off by 1 px at most
  double density_percent = 0;               // answered, of the known
};

// Of all pixels, or of those of a mask.
DisparityErrors evaluate(const Image<float>& disparity, const Image<float>& truth,
                         const Image<std::uint8_t>* mask = nullptr);

}  // namespace glassbox::views
