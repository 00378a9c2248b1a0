// What makes a disparity map out of winners: doubtful pixels are taken out, and what is left is smoothed.
#pragma once

#include <cstdint>

#include <glassbox/images/image.h>
#include <glassbox/raster/lanes/target.h>

namespace glassbox::views {

// Why a pixel is without disparity.
enum class Doubt : std::uint8_t {
  kNone,
  kOccluded,  // the right picture's disparities lead to no pixel of the left one that could be this one
  kMismatched,  // they would, with another disparity
  kUnsure,      // the costs have no clear least (C-111)
  kOutside,     // no disparity of the range stays in the right picture (C-113)
  kSpeckle      // a piece too small
};

// Left pixels whose right pixel has a disparity that differs by more than `tolerance` (px) are in doubt.
Image<Doubt> left_right_doubts(const Image<float>& left, const Image<float>& right, int tolerance);

// Pixels of alpha 0 show nothing, as in a picture that was turned: their colour is no colour, and neither they nor what is matched with
// them has a disparity.
void doubt_empty(const Image<Rgba8>& left, const Image<Rgba8>& right, const Image<float>& disparity,
                 Image<Doubt>& doubts);

// Pixels of connected pieces of fewer than `least` pixels, in which neighbours differ by at most one; pixels in doubt belong to
// none.
void doubt_speckles(const Image<float>& disparity, int least, Image<Doubt>& doubts);

// The median of the finite ones of each pixel's 3 x 3; of an even number the lesser middle one. Pixels without disparity keep none.
Image<float> median_of(const Image<float>& disparity);

// The mean of those of each pixel's 5 x 5 that differ from its own by less than kSmoothed px: parts of a pixel are each of them off
// by their own, and the surface is not. Pixels without disparity keep none.
inline constexpr float kSmoothed = 0.5f;
Image<float> smooth_parts(const Image<float>& disparity, Target target);

}  // namespace glassbox::views
