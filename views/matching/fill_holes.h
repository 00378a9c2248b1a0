// Finds disparities for pixels that have none.
#pragma once

#include <glassbox/images/image.h>

#include "views/matching/color_planes.h"
#include "views/matching/cost_aggregation.h"
#include "views/matching/filters.h"

namespace glassbox::views {

// The greatest length of an arm of the crosses in which pixels vote: on a wide surface without
// texture, longer arms would take much more time and improve little.
inline constexpr int kVoteReach = 17;  // px

// An invalid pixel takes the whole disparity that is most frequent around it: in the vertical arms
// of its cross, and in the horizontal arms of each pixel there. At least 20 of these pixels must
// have a disparity, and at least two fifths of those that have one must agree (Mei et al. 2011).
// This is done `rounds` times. A pixel that got a disparity is no longer invalid.
void fill_by_vote(const Image<Arms>& arms, int first, int count, int rounds,
                  Image<float>& disparity, Image<InvalidReason>& invalid_reasons);

// Fills the pixels that are still invalid from the nearest pixels with a disparity in eight
// directions. A mismatched pixel takes the disparity of the pixel whose colour is most similar to
// its own. Any other pixel is taken for an occluded one: it is behind the surface that hides it, so
// it takes a small disparity, the second smallest that was found (Hirschmueller 2008).
void fill_holes(const ColorPlanes& picture, Image<float>& disparity,
                const Image<InvalidReason>& invalid_reasons);

}  // namespace glassbox::views
