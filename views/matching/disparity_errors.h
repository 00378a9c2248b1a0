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

// Converts disparities from a file: divides them by `scale`. Stored values of 0 and +inf mean
// unknown.
Image<float> known_disparities(Image<float> stored, float scale);

// Whether each pixel's point is visible in the right picture, as far as the left picture's true
// disparities tell. If several pixels are mapped to the same right pixel, the one with the greatest
// disparity is nearest, and so visible; another one is visible if its disparity is less by at most
// one pixel.
Image<std::uint8_t> visible_by_reprojection(const Image<float>& disparity);
// Whether each left pixel's point is visible in the right picture, by the true disparities of both
// pictures: at corresponding pixels they agree to within one pixel (Scharstein and Szeliski 2002).
Image<std::uint8_t> visible_by_right_truth(const Image<float>& left, const Image<float>& right);

// Whether each pixel is near a jump of depth, where a window contains two surfaces: within 4 px,
// across and down, of two neighbouring pixels whose disparities differ by more than 2 px
// (Scharstein and Szeliski 2002).
Image<std::uint8_t> near_discontinuity(const Image<float>& disparity);

inline constexpr std::array<double, 4> kBadAt{0.5, 1, 2, 4};  // px: a larger error is bad

struct DisparityErrors {
  std::uint64_t known = 0;     // pixels with a known truth
  std::uint64_t answered = 0;  // known pixels for which a disparity was found
  // For each limit in kBadAt: the per cent of the known pixels that have an error above it or no
  // disparity.
  std::array<double, 4> bad_percent{};
  // For each limit in kBadAt: the per cent of the answered pixels that have an error above it.
  std::array<double, 4> bad_of_answered{};
  double rms = 0;              // px, over the answered pixels
  double rms_good = 0;         // px, over the pixels with an error of at most 1 px
  double density_percent = 0;  // answered pixels in per cent of the known ones
};

// The errors of all pixels, or only of those where `mask` is not 0.
DisparityErrors disparity_errors(const Image<float>& disparity, const Image<float>& truth,
                                 const Image<std::uint8_t>* mask = nullptr);

}  // namespace glassbox::views
