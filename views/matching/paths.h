// Smoothness along paths (Hirschmueller 2008): L(p, d) = C(p, d) + min(L(q, d), L(q, d +- 1) + P1,
// min L(q) + P2) - min L(q), where q is the pixel before p. The winner is the disparity with the
// least sum over all directions.
#pragma once

#include <array>

#include "views/matching/color_planes.h"
#include "views/matching/cost_volume.h"
#include "views/matching/costs.h"
#include "views/matching/settings.h"
#include "views/matching/winner.h"

namespace glassbox::views {

// Penalties for a step of one disparity (p1), and for any larger step (p2). The latter is less
// where the grey changes, because there a jump of depth is more likely.
struct Penalties {
  std::uint16_t p1 = 100;
  std::uint16_t p2 = 1000;       // where the grey does not change
  std::uint16_t p2_least = 200;  // for any change of grey
  int half_at = 10;              // change of grey, in levels, at which the penalty is halved
};
std::array<std::uint16_t, 256> jump_penalties(const Penalties& penalties);

// The sums of the directions that arrive from above or from the left (down), and of the others
// (up). The two are added to find a pixel's winner.
struct PathSums {
  CostVolume down, up;
};
PathSums sum_paths(const CostVolume& costs, const ColorPlanes& picture, int paths,
                   const Penalties& penalties, Target target);

// Finds the winners with only those paths that do not come from below: 2, 3, 5 or 9 of 2, 4, 8 or
// 16. Bands of rows are summed separately, so that several can be computed at the same time; each
// begins some rows above its own. The bands do not depend on the number of threads. `kept`, of the
// pictures' size, receives the sums.
std::uint64_t bands_of(int height);
struct BandRows {
  // The first row that is summed; the first row whose winners are searched for, and the one after
  // the last.
  int warm_up, begin, end;
};
BandRows band_rows(int band, int height);
Winners sweep_once(const PixelCosts& costs, const ColorPlanes& picture,
                   const MatchSettings& settings, const Penalties& penalties,
                   CostVolume* kept = nullptr);

}  // namespace glassbox::views
