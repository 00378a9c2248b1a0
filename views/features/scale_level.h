// A picture as grey levels at several scales. A corner that is large in one picture and small in
// the other looks the same at two different scales.
#pragma once

#include <glassbox/images/image.h>

namespace glassbox::views {

// A picture at one scale. A pixel (x, y) of it, from its top left corner, is the pixel (scale x,
// scale y) of the picture, so that the centre of the first pixel is (0.5, 0.5) at every scale.
struct ScaleLevel {
  Image<float> grey;  // sRGB codes, 0 .. 255: (77 r + 150 g + 29 b)/256, smoothed
  double scale = 1;   // px of the picture for one pixel of this level
};

// The standard deviation of the smoothing at every level, px of the level. The picture's own is
// taken for half a pixel (Lowe, IJCV 60, 2004, section 3.3).
inline constexpr double kLevelSigma = 0.8;
// The ratio of two successive scales (Rublee et al., ORB, ICCV 2011, section 6.1).
inline constexpr double kScaleStep = 1.2;

// The level of scale 1. Alpha is left out.
ScaleLevel finest_level(const Image<Rgba8>& picture);

// The level of the next scale, with at least one pixel.
ScaleLevel coarser_level(const ScaleLevel& finer);

// The picture convolved with a Gaussian of standard deviation `sigma` px, cut off at 3 sigma; the
// pixels at the edge are repeated outwards.
Image<float> smoothed(const Image<float>& grey, double sigma);

// The value at a position in px from the top left corner, interpolated between the four nearest
// pixel centres. Positions beyond the outermost centres are taken for the nearest of these.
double grey_at(const Image<float>& grey, double x, double y);

}  // namespace glassbox::views
