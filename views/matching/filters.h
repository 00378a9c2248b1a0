// Makes a disparity map from the winners: invalid pixels are removed, and the rest is smoothed.
#pragma once

#include <cstdint>

#include <glassbox/images/image.h>
#include <glassbox/raster/lanes/target.h>

namespace glassbox::views {

// The reason why a pixel has no disparity.
enum class InvalidReason : std::uint8_t {
  kNone,
  kOccluded,    // no right pixel's disparity leads to this left pixel
  kMismatched,  // a right pixel's disparity leads to it, but the two disparities differ
  kUnsure,      // the costs have no clear minimum (C-111)
  kOutside,  // for every disparity of the range, the right pixel is outside of the picture (C-113)
  kSpeckle   // in a connected piece that is too small
};

// Marks left pixels whose right pixel has a disparity that differs by more than `tolerance` (px).
Image<InvalidReason> left_right_check(const Image<float>& left, const Image<float>& right,
                                      int tolerance);

// Marks pixels of alpha 0, which show nothing (as in a rectified picture): they have no colour, and
// neither they nor the pixels matched with them get a disparity.
void invalidate_empty(const Image<Rgba8>& left, const Image<Rgba8>& right,
                      const Image<float>& disparity, Image<InvalidReason>& invalid_reasons);

// Marks the pixels of connected pieces of fewer than `least` pixels. Neighbours are connected if
// their disparities differ by at most one; pixels that are already invalid belong to no piece.
void invalidate_speckles(const Image<float>& disparity, int least,
                         Image<InvalidReason>& invalid_reasons);

// The median of the finite values in each pixel's 3 x 3 neighbourhood; for an even number of them,
// the smaller middle one. Pixels without disparity remain without.
Image<float> median_of(const Image<float>& disparity);

// The mean of those values in each pixel's 5 x 5 neighbourhood that differ from its own by less
// than kSmoothed px: the errors in the fractions of a pixel are independent, while the surface is
// smooth. Pixels without disparity remain without.
inline constexpr float kSmoothed = 0.5f;
Image<float> smooth_parts(const Image<float>& disparity, Target target);

}  // namespace glassbox::views
