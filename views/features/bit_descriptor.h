// A feature as bits: each says which of two places around it is darker. The places turn with the
// feature (Rublee et al., ORB: an efficient alternative to SIFT or SURF, ICCV 2011).
#pragma once

#include <array>
#include <cstdint>

#include <glassbox/images/image.h>

namespace glassbox::views {

inline constexpr int kDescriptorBits = 256;
using BitDescriptor = std::array<std::uint64_t, kDescriptorBits / 64>;

// The two places of each comparison, in px from the feature: (x, y) of the first, then of the
// second. The pattern is this project's own. Every coordinate is drawn from a normal distribution
// of standard deviation kPatternSigma (Calonder et al., BRIEF, ECCV 2010, their best of five:
// 31/5 px), as the sum of 12 uniform numbers minus 6, from the generator of base/random.h with the
// seed kPatternSeed. A place farther than kPatternRadius from the feature is drawn again. So is a
// pair whose places are less than kLeastApart px apart, where noise would decide.
inline constexpr double kPatternSigma = 6.2;  // px
inline constexpr double kPatternRadius = 13;  // px
inline constexpr double kLeastApart = 2;      // px
inline constexpr std::uint64_t kPatternSeed = 1;
using BitPattern = std::array<std::array<double, 4>, kDescriptorBits>;
const BitPattern& bit_pattern();

// The direction from the feature to the centroid of the grey levels in a circle of kCentroidRadius
// px, radians: atan2(sum y I, sum x I) with x and y relative to the feature (Rosin 1999; Rublee et
// al., section 3.2). 0 if all grey levels are equal.
inline constexpr int kCentroidRadius = 13;
double centroid_angle(const Image<float>& grey, double x, double y);

// The standard deviation of the smoothing before grey levels are compared, px; it is applied to a
// level, which is already smoothed by kLevelSigma.
inline constexpr double kComparedSigma = 1.5;

// `grey` is a level after smoothing with kComparedSigma; (x, y) is in its px, and at least
// kFeatureMargin from its edges.
BitDescriptor bit_descriptor(const Image<float>& grey, double x, double y, double angle);

// The number of bits that differ.
double distance(const BitDescriptor& a, const BitDescriptor& b);

}  // namespace glassbox::views
