// A single sweep over census costs in bytes: of three paths, from the left, from above and from the right, no sum is as great as 255,
// and 32 disparities are summed at a time.
#pragma once

#include <cstdint>

#include "views/matching/pictures.h"
#include "views/matching/settings.h"
#include "views/matching/winner.h"

namespace glassbox::views {

// Whether the settings ask for nothing else.
bool fits_bytes(const MatchSettings& settings);
// What each band of rows takes.
std::uint64_t bytes_of_byte_band(int width, int stride);
// As sweep_once; `kept`, of the pictures' size, takes the sums.
Winners sweep_in_bytes(const Planes& left, const Planes& right, const MatchSettings& settings,
                       CostVolume* kept = nullptr);

}  // namespace glassbox::views
