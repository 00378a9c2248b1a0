// Slanted planes improve the last half pixel of the disparities (C-112): around each pixel the
// surface is d = c + a dx + b dy. The neighbours' planes are tried first, then the best one is
// fitted (as in PatchMatch Stereo, Bleyer, Rhemann and Rother 2011; the fit is Gruen's least
// squares matching, 1985).
#pragma once

#include <glassbox/images/image.h>

#include "views/matching/color_planes.h"
#include "views/matching/filters.h"

namespace glassbox::views {

// Moves disparities of pixels that are not invalid by at most kPlaneReach px, to the place where
// the grey of a window of 11 x 11, slanted as its plane says, is most similar to the left one's up
// to an offset. Only pixels of the window whose disparity is near the plane count, and their weight
// is greater the more similar their colour is. Each round takes the best of the neighbours' planes,
// and fits it.
inline constexpr float kPlaneReach = 1;
void fit_planes(const ColorPlanes& left, const ColorPlanes& right,
                const Image<InvalidReason>& invalid_reasons, int rounds, Image<float>& disparity);

}  // namespace glassbox::views
