// Corners: the places where the response is larger than around them.
#pragma once

#include <array>
#include <vector>

#include "views/features/corner_response.h"

namespace glassbox::views {

struct PictureCorner {
  double x = 0, y = 0;  // px from the top left corner, with parts of a pixel
  double strength = 0;  // the response at the pixel
};

// A response below kLeastShare of the map's largest (for Harris's, whose unit is a square,
// kLeastShare^2) is no corner.
inline constexpr double kLeastShare = 0.01;
// Nor is a window that changes by less than this in some direction: an eigenvalue l2 below it, in
// (grey levels/px)^2. Rounding to whole grey levels gives about 0.008: the variance 1/12 of a
// pixel, times 1/(8 pi sigma^4) for the gradient after smoothing with sigma = kLevelSigma.
inline constexpr double kFaintestCorner = 0.05;

// The local maxima of a map, in the order of rows: pixels that no one of the 8 neighbours exceeds,
// at least `margin` pixels from the edges (margin >= 1). The first of equal neighbours counts.
std::vector<PictureCorner> corners_of(const Image<float>& map, Detector detector, int margin);

// Where the quadratic function through a pixel's 3 x 3 responses (rows from the top) has its
// maximum, relative to the pixel's centre, px. With the central differences g of first and H of
// second order it is -H^-1 g (Brown and Lowe, Invariant features from interest point groups, 2002,
// equation 3). (0, 0) if it is no maximum, or more than a pixel away in x or y. Harris's response
// is smooth at its peak; that of Shi and Tomasi has a tip there, because of the square root, and
// the fit is less accurate.
std::array<double, 2> quadratic_peak(const std::array<std::array<double, 3>, 3>& responses);

}  // namespace glassbox::views
