// Improves disparities by fractions of a pixel with slanted planes (C-112): around each pixel the
// surface is d = c + a dx + b dy, the disparity d at the offset (dx, dy) from the pixel. The planes
// of a pixel's neighbours are tried first, then the best plane is improved by a fit (as in
// PatchMatch Stereo, Bleyer, Rhemann and Rother 2011; the fit is Gruen's least squares matching,
// 1985).
#pragma once

#include <glassbox/images/image.h>

#include "views/matching/color_planes.h"
#include "views/matching/filters.h"

namespace glassbox::views {

// Changes the disparity of each valid pixel by at most kPlaneReach px. A plane maps a window of 11
// x 11 pixels around the pixel into the right picture; the best plane is the one for which the grey
// there is most similar to the left picture's, apart from a constant difference. Only pixels of the
// window whose disparity is near the plane are compared, and the more similar their colour is to
// the centre's, the greater is their weight. Each of the `rounds` takes the best of the pixel's own
// plane and its neighbours' planes, and improves it by a fit.
inline constexpr float kPlaneReach = 1;
void fit_planes(const ColorPlanes& left, const ColorPlanes& right,
                const Image<InvalidReason>& invalid_reasons, int rounds, Image<float>& disparity);

}  // namespace glassbox::views
