// Splats with partly transparent rims (S1-10).
#pragma once

#include <glassbox/images/image.h>

#include "views/layers/warp_kernels.h"

namespace glassbox::views {

inline constexpr int kLargestFootprint = 7;  // px

// Paints a splat over the canvas around pixel (x, y): 1, 3, 5 or 7 pixels wide, the smallest of
// these that is at least `side`. Its alpha is 1, 1/2 or 1/4 as in Shade et al., so that blending
// needs only additions and shifts. It is a Gaussian with 1/2 at the middle of an edge and 1/4 at
// the corners, rounded to these three values.
void paint_footprint(int x, int y, int side, SampleKey key, Rgba8 background,
                     const KeyCanvas& canvas);

}  // namespace glassbox::views
