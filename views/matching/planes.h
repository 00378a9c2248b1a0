// Planes that slant, for the last half pixel (C-112): around every pixel the surface is d = c + a dx + b dy, and what the neighbours found
// is tried before it is fitted (as in PatchMatch Stereo, Bleyer, Rhemann and Rother 2011; the fit is Gruen's least squares matching, 1985).
#pragma once

#include <glassbox/images/image.h>

#include "views/matching/filters.h"
#include "views/matching/pictures.h"

namespace glassbox::views {

// Disparities of pixels that are not in doubt move by at most kPlaneReach px, to where the grey of a window of 11 x 11, slanted as its
// plane says, is most like the left one's, but for an offset. Only those pixels of the window count whose disparity is near the plane,
// and the more the liker their colour is. Each round takes the best of the planes around, and fits it.
inline constexpr float kPlaneReach = 1;
void fit_planes(const Planes& left, const Planes& right, const Image<Doubt>& doubts, int rounds,
                Image<float>& disparity);

}  // namespace glassbox::views
