// Samples that are seen through at their rims (S1-10).
#pragma once

#include <glassbox/images/image.h>

#include "views/layers/warp_kernels.h"

namespace glassbox::views {

inline constexpr int kLargestFootprint = 7;  // px

// Over what is there, around pixel (x, y): 1, 3, 5 or 7 pixels wide, the odd number from `side` up. Its alpha is 1, 1/2 or 1/4, as
// Shade et al. have it, so that to blend is to add and to shift: a Gaussian with 1/2 at the middle of an edge and 1/4 at the
// corners, rounded to these three.
void paint_footprint(int x, int y, int side, SampleKey key, Rgba8 background,
                     const KeyCanvas& canvas);

}  // namespace glassbox::views
