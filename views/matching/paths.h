// Sums of costs and penalties along paths, which favour smooth surfaces (semi-global matching,
// Hirschmueller 2008). The value of a path at pixel p and disparity d is L(p, d) = C(p, d) +
// min(L(q, d), L(q, d +- 1) + P1, min L(q) + P2) - min L(q), where C is the cost, P1 and P2 are
// penalties, and q is the pixel before p on the path. The winner is the disparity with the least
// sum of L over all directions.
#pragma once

#include <array>

#include "views/matching/color_planes.h"
#include "views/matching/cost_volume.h"
#include "views/matching/costs.h"
#include "views/matching/settings.h"
#include "views/matching/winner.h"

namespace glassbox::views {

// Penalties for a change of disparity by one (p1), and by more (p2), from one pixel of a path to
// the next. p2 is less where the grey changes, because there a jump of depth is more likely.
struct Penalties {
  std::uint16_t p1 = 100;
  std::uint16_t p2 = 1000;       // where the grey does not change
  std::uint16_t p2_least = 200;  // the least p2, for any change of grey
  int half_at = 10;              // change of grey, in levels, that halves p2
};
std::array<std::uint16_t, 256> jump_penalties(const Penalties& penalties);

// `down` has the sums over the paths that arrive from the left or from above, `up` the sums over
// the paths in the opposite directions. The two are added to find a pixel's winner.
struct PathSums {
  CostVolume down, up;
};
PathSums sum_paths(const CostVolume& costs, const ColorPlanes& picture, int paths,
                   const Penalties& penalties, Target target);

// A single sweep finds the winners with only those paths that do not come from below: 2, 3, 5 or 9
// paths instead of 2, 4, 8 or 16. Bands of rows are summed separately, so that several can be
// computed at the same time. The sums of a band begin some rows above it, so that its first rows
// have paths from above, too. The bands do not depend on the number of threads. If `kept` is given,
// a volume of the pictures' size, it receives the sums.
std::uint64_t bands_of(int height);
struct BandRows {
  // warm_up is the first row that is summed, `begin` the first row whose winners are searched for,
  // and `end` the row after the last.
  int warm_up, begin, end;
};
BandRows band_rows(int band, int height);
DisparityMaps sweep_once(const PixelCosts& costs, const ColorPlanes& picture,
                         const MatchSettings& settings, const Penalties& penalties,
                         CostVolume* kept = nullptr);

}  // namespace glassbox::views
