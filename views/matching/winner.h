// Finds the disparity of least cost for every pixel of both pictures.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include <glassbox/images/image.h>

#include "views/matching/cost_volume.h"
#include "views/matching/settings.h"

namespace glassbox::views {

// Marks a pixel without disparity, in memory and in files; published pairs mark their truth in the
// same way (C-114).
inline constexpr float kNoDisparity = std::numeric_limits<float>::infinity();

struct Winners {
  Image<float> left;        // px; with a fraction of a pixel if requested
  Image<float> right;       // px, whole numbers
  Image<float> confidence;  // (second - best) / second, in [0, 1]
};

// The position, in [-1/2, 1/2], at which two lines of opposite slope through the costs of three
// neighbours meet. Costs that are sums of absolute differences have such a corner at their minimum,
// and not a parabola.
inline float corner(int before, int least, int behind) {
  const int steep = std::max(before, behind) - least;
  return steep == 0 ? 0.0f : float(before - behind) / float(2 * steep);
}

// The winners of one volume, or of the sum of two. Disparities whose right pixel is outside of the
// picture are not considered; a pixel that has no others gets no disparity (C-113).
Winners find_winners(const CostVolume& costs, const CostVolume* more, bool subpixel, Target target);

// The winners of the pictures' row y only, whose costs are in row `from_row` of the volume;
// no_winners() makes the result that they are written into.
Winners no_winners(int width, int height);
void winners_of_row(const CostVolume& volume, const CostVolume* more, int from_row, int y,
                    bool subpixel, Target target, Winners& winners);

}  // namespace glassbox::views
