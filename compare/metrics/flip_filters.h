// The filters of FLIP: how finely an eye resolves lightness and colour, and what it sees as an edge
// or a point.
#pragma once

#include <numbers>

#include <glassbox/compare/metrics/filter.h>

namespace glassbox {

// 67.02: a monitor 0.7 m wide with 3840 pixels, seen from 0.7 m. This is the default of the paper's
// authors.
inline constexpr double kPixelsPerDegree = 0.7 * (3840 / 0.7) * std::numbers::pi / 180;

// The radii of the filters in px: three standard deviations of the widest filter for colours, and
// of the one for edges and points, rounded up.
inline constexpr int kColourRadius = 10;
inline constexpr int kFeatureRadius = 9;

struct FlipFilters {
  // Contrast sensitivity (section 4.1.1 of the paper). The Gaussians of lightness and of red-green
  // are so narrow that less than 2^-32 of their weight is outside these radii; the paper uses 10
  // for all.
  Taps<float, 6> lightness;
  Taps<float, 7> red_green;
  // Blue-yellow is the sum of two Gaussians, each separable; `wide_share` is the wide one's
  // fraction of the sum of all weights.
  Taps<float, kColourRadius> wide_blue_yellow, narrow_blue_yellow;
  float wide_share = 0, narrow_share = 0;

  // Feature detection (section 4.2): a Gaussian, and its first and second derivative, with the
  // positive weights scaled to the sum 1 and the negative ones to the sum -1.
  Taps<float, kFeatureRadius> smooth, slope, bend;
};

const FlipFilters& flip_filters();

}  // namespace glassbox
