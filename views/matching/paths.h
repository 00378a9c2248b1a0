// Smoothness along paths (Hirschmueller 2008): L(p, d) = C(p, d) + min(L(q, d), L(q, d +- 1) + P1, min L(q) + P2) - min L(q), where q
// is the pixel before p; the sum over directions is what the winner is sought in.
#pragma once

#include <array>

#include "views/matching/cost_volume.h"
#include "views/matching/costs.h"
#include "views/matching/pictures.h"
#include "views/matching/settings.h"
#include "views/matching/winner.h"

namespace glassbox::views {

// Of a step of one disparity, and of any other: the latter is less where the grey changes, because depth is likelier to.
struct Penalties {
  std::uint16_t p1 = 100;
  std::uint16_t p2 = 1000;       // of no change
  std::uint16_t p2_least = 200;  // of any
  int half_at = 10;              // codes of grey at which the penalty has halved
};
std::array<std::uint16_t, 256> jump_penalties(const Penalties& penalties);

// The sums of the directions that arrive from above or from the left, and of the others; a pixel's are added to find its winner.
struct PathSums {
  CostVolume down, up;
};
PathSums sum_paths(const CostVolume& costs, const Planes& picture, int paths,
                   const Penalties& penalties, Target target);

// The winners of those paths that do not come from below: 2, 3, 5 or 9 of 2, 4, 8 or 16. Bands of rows are summed apart, each from
// some rows above it on, so that several can be at the same time; where they begin does not depend on how many threads there are.
// `kept`, of the pictures' size, takes the sums.
std::uint64_t bands_of(int height);
struct BandRows {
  int warm_up, begin,
      end;  // the first row that is summed; the first and the last but one whose winners are sought
};
BandRows band_rows(int band, int height);
Winners sweep_once(const PixelCosts& costs, const Planes& picture, const MatchSettings& settings,
                   const Penalties& penalties, CostVolume* kept = nullptr);

}  // namespace glassbox::views
