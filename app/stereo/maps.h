// Findings as pictures.
#pragma once

#include <cstdint>

#include "app/stereo/findings.h"

#include <glassbox/images/image.h>

namespace glassbox::app {

// A colour for each disparity from -limit_px (orange, in front) over 0 (near white) to limit_px (blue, behind), and
// what is beyond the budget in stripes. Nothing drawn is dark grey.
Image<Rgba8> disparity_picture(const Image<float>& disparity, const ParallaxBudget& budget,
                               double limit_px);
Rgba8 disparity_colour(double px, double limit_px);

// Sizes of the values from 0 (black) to `limit` (white).
Image<Rgba8> heat_of(const Image<float>& values, double limit);

// For a share of the limit: heat_colours, but with black growing into them, since here the smallest value is no
// difference that must be seen.
Rgba8 heat_colour(double share);

// The larger size of the two.
Image<float> larger_of(const Image<float>& a, const Image<float>& b);

// Edges that the eyes see at different places in orange, other edges in blue, over the picture in dim grey.
Image<Rgba8> information_picture(const Image<Rgba8>& left, const Image<std::uint8_t>& marks);

// The pixels of pieces that the picture's edge cuts, in red over the picture in grey.
Image<Rgba8> violation_picture(const Image<Rgba8>& eye, const Image<std::uint8_t>& marks);

// What only this eye sees: hidden in orange, beside the other picture in blue, missing there in magenta.
Image<Rgba8> monocular_picture(const Image<Rgba8>& eye, const Image<OtherEye>& map);

}  // namespace glassbox::app
