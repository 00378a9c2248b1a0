// Finds disparities for pixels that have none.
#pragma once

#include <glassbox/images/image.h>

#include "views/matching/color_planes.h"
#include "views/matching/cost_aggregation.h"
#include "views/matching/filters.h"

namespace glassbox::views {

// The maximum length of an arm: longer ones cost more on a wide blank surface than they improve.
inline constexpr int kVoteReach = 17;  // px

// An invalid pixel takes the disparity that most pixels of its cross have, if at least 20 of them
// have one and two fifths of those agree (Mei et al. 2011). This is done `rounds` times. A pixel
// that got a disparity is no longer invalid.
void fill_by_vote(const Image<Arms>& arms, int first, int count, int rounds,
                  Image<float>& disparity, Image<InvalidReason>& invalid_reasons);

// Fills the pixels that are still invalid from the nearest pixels with a disparity in eight
// directions. An occluded pixel is behind the surface that hides it, so it takes the second
// smallest disparity found. A mismatched pixel takes the disparity of the pixel whose colour is
// most similar to its own.
void fill_holes(const ColorPlanes& picture, Image<float>& disparity,
                const Image<InvalidReason>& invalid_reasons);

}  // namespace glassbox::views
