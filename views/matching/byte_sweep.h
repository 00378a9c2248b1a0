// A single sweep over census costs that computes with bytes: the sum of three paths (from the left,
// from above and from the right) is always below 255, so 32 disparities are processed at once.
#pragma once

#include <cstdint>

#include "views/matching/color_planes.h"
#include "views/matching/settings.h"
#include "views/matching/winner.h"

namespace glassbox::views {

// Whether this sweep can do everything that the settings ask for.
bool fits_bytes(const MatchSettings& settings);
// Bytes of memory for one band of rows.
std::uint64_t bytes_of_byte_band(int width, int stride);
// Like sweep_once (paths.h). If `kept` is given, a volume of the pictures' size, it receives the
// sums.
DisparityMaps sweep_in_bytes(const ColorPlanes& left, const ColorPlanes& right,
                             const MatchSettings& settings, CostVolume* kept = nullptr);

}  // namespace glassbox::views
