// Disparities for pixels that have none.
#pragma once

#include <glassbox/images/image.h>

#include "views/matching/filters.h"
#include "views/matching/pictures.h"
#include "views/matching/support.h"

namespace glassbox::views {

// How far along an arm: beyond it a wide blank surface costs more than it tells.
inline constexpr int kVoteReach = 17;  // px

// Pixels in doubt take the disparity that most pixels of their cross have, where at least 20 have one and two fifths of them agree
// (Mei et al.
// 2011); `rounds` times over. What was voted on is no longer in doubt.
void vote(const Image<Arms>& arms, int first, int count, int rounds, Image<float>& disparity,
          Image<Doubt>& doubts);

// What is still in doubt looks in eight directions for pixels that are not. What the other eye does not see stands behind what
// hides it:
// it takes the second least disparity found; what was mismatched takes the one whose pixel's colour is most like its own.
void fill_holes(const Planes& picture, Image<float>& disparity, const Image<Doubt>& doubts);

}  // namespace glassbox::views
