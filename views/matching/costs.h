// The first step of a dense match: how unlike the pixels of a pair are, for every disparity (SPEC S2-04).
#pragma once

#include "views/matching/census.h"
#include "views/matching/cost_volume.h"
#include "views/matching/pictures.h"
#include "views/matching/settings.h"

namespace glassbox::views {

// Costs of single pixels, or of the correlation's window; a window of the others is for average_costs. Where the right pixel would
// lie beside the picture the cost is kHighestCost: nothing speaks for such a match, and the winner is not sought there. The pictures
// must outlive it.
class PixelCosts {
public:
  PixelCosts(const Planes& left, const Planes& right, const MatchSettings& settings);
  CostVolume volume_of(int rows) const;
  // Of the pictures' row y, into any row of such a volume.
  void row(int y, CostVolume& volume, int to_row) const;

private:
  const Planes &left_, &right_;
  const MatchSettings& settings_;
  LineVector<std::uint32_t> left_words_, right_words_;                // of census costs
  CensusPlanes left_bytes_, right_bytes_, left_alike_, right_alike_;  // of census and colour
};

CostVolume pixel_costs(const Planes& left, const Planes& right, const MatchSettings& settings);

}  // namespace glassbox::views
