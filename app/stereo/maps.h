// The findings as pictures.
#pragma once

#include <cstdint>

#include "app/stereo/findings.h"

#include <glassbox/images/image.h>

namespace glassbox::app {

// A picture with a colour for each disparity from -limit_px (orange, in front) over 0 (near white)
// to limit_px (blue, behind). Disparities beyond the budget have stripes. Pixels where nothing is
// drawn are dark grey.
Image<Rgba8> disparity_picture(const Image<float>& disparity, const ParallaxBudget& budget,
                               double limit_px);
Rgba8 disparity_colour(double px, double limit_px);

// The absolute values as a heat map from 0 (black) to `limit` (white).
Image<Rgba8> heat_of(const Image<float>& values, double limit);

// For each pixel, the larger absolute value of the two.
Image<float> larger_of(const Image<float>& a, const Image<float>& b);

// Edges that the eyes see at different positions in orange, other edges in blue, over the picture
// in dark grey.
Image<Rgba8> information_picture(const Image<Rgba8>& left, const Image<std::uint8_t>& marks);

// The pixels of surfaces that the picture's edge cuts in red, over the picture in grey.
Image<Rgba8> violation_picture(const Image<Rgba8>& eye, const Image<std::uint8_t>& marks);

// Pixels that only this eye sees: hidden from the other eye in orange, outside the other picture in
// blue, missing there in magenta.
Image<Rgba8> monocular_picture(const Image<Rgba8>& eye, const Image<OtherEye>& map);

}  // namespace glassbox::app
