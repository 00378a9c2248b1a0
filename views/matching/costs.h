// The first step of a dense match: how different the pixels of a pair are, for every disparity
// (S2-04).
#pragma once

#include "views/matching/census.h"
#include "views/matching/color_planes.h"
#include "views/matching/cost_volume.h"
#include "views/matching/settings.h"

namespace glassbox::views {

// The costs of single pixels, which average_costs can average over windows, or, for a correlation,
// the costs of each pixel's window. If the right pixel would be outside of the picture, the cost is
// kHighestCost, and the disparity cannot be the winner. The pictures must outlive the object.
class PixelCosts {
public:
  PixelCosts(const ColorPlanes& left, const ColorPlanes& right, const MatchSettings& settings);
  CostVolume volume_of(int rows) const;
  // Writes the costs of the pictures' row y into row `to_row` of a volume.
  void row(int y, CostVolume& volume, int to_row) const;

private:
  const ColorPlanes &left_, &right_;
  const MatchSettings& settings_;
  CacheAlignedVector<std::uint32_t> left_words_, right_words_;            // for census costs
  CensusPlanes left_bytes_, right_bytes_, left_similar_, right_similar_;  // for census and colour
};

CostVolume pixel_costs(const ColorPlanes& left, const ColorPlanes& right,
                       const MatchSettings& settings);

}  // namespace glassbox::views
