// Averages costs over pixels that are likely to be on the same surface.
#pragma once

#include <cstdint>

#include <glassbox/images/image.h>

#include "views/matching/color_planes.h"
#include "views/matching/cost_volume.h"
#include "views/matching/settings.h"

namespace glassbox::views {

// The cross around a pixel over which its costs are averaged: the number of pixels in each of its
// four arms, without the pixel itself.
struct Arms {
  std::uint8_t left = 0, right = 0, up = 0, down = 0;
};

// The arms of a cross that stop where the colour changes: where a channel differs from the centre's
// by more than 20, or, beyond 17 pixels, by more than 6. An arm has at most `longest` pixels, which
// can be up to 255 (lengths and thresholds are those of Mei et al. 2011).
inline constexpr int kLongestArm = 34;  // px
Image<Arms> adaptive_arms(const ColorPlanes& picture, int longest = kLongestArm);

// The arms of a cross in a square window, cut off at the picture's edge.
Image<Arms> square_arms(int width, int height, int radius);

// Averages the costs in two steps. kRows: each cost is replaced by a mean along its pixel's row,
// and then these means are averaged along the column; kColumns: along the column first, then along
// the row.
enum class AggregationOrder : std::uint8_t { kRows, kColumns };
void average_costs(CostVolume& volume, const Image<Arms>& arms, AggregationOrder first,
                   Target target);

}  // namespace glassbox::views
