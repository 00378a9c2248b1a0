// The disparity that costs least, of every pixel of either picture.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include <glassbox/images/image.h>

#include "views/matching/cost_volume.h"
#include "views/matching/settings.h"

namespace glassbox::views {

// A pixel without disparity, in memory and in files, as in the truth of published pairs (C-114).
inline constexpr float kNoDisparity = std::numeric_limits<float>::infinity();

struct Winners {
  Image<float> left;        // px; with a part of a pixel where asked for
  Image<float> right;       // px, whole
  Image<float> confidence;  // (second - best) / second, in [0, 1]
};

// Where two lines of opposite slope through the costs of three neighbours meet: in [-1/2, 1/2]. Costs that are sums of absolute
// differences have such a corner, not a parabola's round bottom.
inline float corner(int before, int least, int behind) {
  const int steep = std::max(before, behind) - least;
  return steep == 0 ? 0.0f : float(before - behind) / float(2 * steep);
}

// Of one volume, or of the sum of two. Disparities whose right pixel lies beside the picture are never sought: a pixel that has no
// other is without (C-113).
Winners find_winners(const CostVolume& costs, const CostVolume* more, bool subpixel, Target target);

// Of the pictures' row y alone, whose costs are row `from_row` of the volume, into such winners.
Winners no_winners(int width, int height);
void winners_of_row(const CostVolume& volume, const CostVolume* more, int from_row, int y,
                    bool subpixel, Target target, Winners& winners);

}  // namespace glassbox::views
