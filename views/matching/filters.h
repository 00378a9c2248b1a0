// Improves the disparity map of the winners (the disparities of least cost): marks pixels as
// invalid, and smooths the valid ones.
#pragma once

#include <cstdint>

#include <glassbox/images/image.h>
#include <glassbox/raster/lanes/target.h>

namespace glassbox::views {

// The reason why a pixel has no disparity.
enum class InvalidReason : std::uint8_t {
  kNone,
  kOccluded,    // failed the left-right check; no right pixel's disparity leads here
  kMismatched,  // failed the left-right check, but a right pixel's disparity leads here
  kUnsure,      // the costs have no clear minimum (C-111)
  kOutside,  // for every disparity of the range, the right pixel is outside of the picture (C-113)
  kSpeckle   // in a connected region of too few pixels
};

// Marks left pixels whose disparity differs by more than `tolerance` (px) from the disparity of the
// right pixel that it leads to.
Image<InvalidReason> left_right_check(const Image<float>& left, const Image<float>& right,
                                      int tolerance);

// Marks pixels of alpha 0, and pixels that are matched with a right pixel of alpha 0. Such pixels
// show nothing (a rectified picture has them outside of the original one), so no disparity can be
// found for them.
void invalidate_empty(const Image<Rgba8>& left, const Image<Rgba8>& right,
                      const Image<float>& disparity, Image<InvalidReason>& invalid_reasons);

// Marks the pixels of connected regions of fewer than `least` pixels. Neighbours are connected if
// their disparities differ by at most one pixel; pixels that are already invalid belong to no
// region.
void invalidate_speckles(const Image<float>& disparity, int least,
                         Image<InvalidReason>& invalid_reasons);

// The median of the finite values in each pixel's 3 x 3 neighbourhood; for an even number of
// values, the smaller of the two in the middle. Pixels without disparity remain without one.
Image<float> median_of(const Image<float>& disparity);

// The mean of the values in each pixel's 5 x 5 neighbourhood that differ from the pixel's own by
// less than kSmoothed px. The mean is more accurate than a single value, because the errors in the
// fractions of a pixel are independent, while the surface is smooth. Pixels without disparity
// remain without one.
inline constexpr float kSmoothed = 0.5f;
Image<float> smooth_parts(const Image<float>& disparity, Target target);

}  // namespace glassbox::views
