// Finds the disparity of least cost (the winner) for every pixel of both pictures.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include <glassbox/images/image.h>

#include "views/matching/cost_volume.h"
#include "views/matching/settings.h"

namespace glassbox::views {

// Marks a pixel without disparity, in memory and in files; published stereo pairs mark unknown
// disparities in the same way (C-114).
inline constexpr float kNoDisparity = std::numeric_limits<float>::infinity();

struct DisparityMaps {
  Image<float> left;        // px; with a fraction of a pixel if requested
  Image<float> right;       // px, whole numbers
  Image<float> confidence;  // peak ratio (settings.h), in [0, 1]
};

// The position of the minimum relative to the least of three neighbouring costs, in [-1/2, 1/2]:
// where two lines of opposite slope through the three costs meet. Sums of absolute differences have
// such a corner at their minimum, and not a parabola.
inline float corner(int before, int least, int behind) {
  const int steep = std::max(before, behind) - least;
  return steep == 0 ? 0.0f : float(before - behind) / float(2 * steep);
}

// The winners of one volume, or of the sum of two volumes. Disparities whose right pixel is outside
// of the picture are not considered; a pixel that has no other disparities gets kNoDisparity
// (C-113).
DisparityMaps find_winners(const CostVolume& costs, const CostVolume* more, bool subpixel,
                           Target target);

// winners_of_row finds the winners of the pictures' row y only, whose costs are in row `from_row`
// of the volume. no_winners makes the result that winners_of_row writes into, with no disparity
// anywhere.
DisparityMaps no_winners(int width, int height);
void winners_of_row(const CostVolume& volume, const CostVolume* more, int from_row, int y,
                    bool subpixel, Target target, DisparityMaps& winners);

}  // namespace glassbox::views
