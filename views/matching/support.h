// Costs averaged over pixels that are likely to lie on the same surface.
#pragma once

#include <cstdint>

#include <glassbox/images/image.h>

#include "views/matching/cost_volume.h"
#include "views/matching/pictures.h"
#include "views/matching/settings.h"

namespace glassbox::views {

// How many pixels each arm of a pixel's cross has, the pixel itself left out.
struct Arms {
  std::uint8_t left = 0, right = 0, up = 0, down = 0;
};

// Arms that stop where a channel differs from the centre's by more than 20, or, beyond 17 pixels, by more than 6; at most `longest`
// long, to 255 (Mei et al. 2011; lengths and thresholds are theirs).
inline constexpr int kLongestArm = 34;  // px
Image<Arms> adaptive_arms(const Planes& picture, int longest = kLongestArm);

// Arms of a square window, which stop at the picture's edge.
Image<Arms> square_arms(int width, int height, int radius);

// Each cost becomes the mean along its pixel's row, then those means' mean along the column; or the column first.
enum class FirstAlong : std::uint8_t { kRows, kColumns };
void average_costs(CostVolume& volume, const Image<Arms>& arms, FirstAlong first, Target target);

}  // namespace glassbox::views
