// A feature as the grey levels around it, for normalised cross-correlation.
#pragma once

#include <array>

#include <glassbox/images/image.h>

namespace glassbox::views {

// A window of 15 x 15 pixels around the feature, minus its mean, and scaled to length 1: a gain and
// an offset of the picture's grey change nothing. All are 0 if all grey levels are equal. The
// window is not turned.
inline constexpr int kPatchRadius = 7;  // px
inline constexpr int kPatchSide = 2 * kPatchRadius + 1;
using WindowDescriptor = std::array<float, std::size_t(kPatchSide* kPatchSide)>;

// (x, y) is in px of `grey`, and at least kPatchRadius from its edges.
WindowDescriptor window_descriptor(const Image<float>& grey, double x, double y);

// The length of the difference of two windows, sqrt(2 - 2 c), where c is their normalised
// cross-correlation (from -1 to 1): 0 for equal windows, at most 2.
double distance(const WindowDescriptor& a, const WindowDescriptor& b);

}  // namespace glassbox::views
