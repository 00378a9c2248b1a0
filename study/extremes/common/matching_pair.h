// Rectified pairs with known disparities, and matches between them.
#pragma once

#include <cstdint>

#include <glassbox/base/random.h>

#include "views/matching/match.h"

namespace glassbox::study {

// Grey noise from 0 to `most`.
Image<Rgba8> grey_noise(int width, int height, std::uint64_t seed, int most = 255);

// The right camera's picture of a wall at disparity d, which may be negative: right(x - d) =
// left(x). Columns that come in at the edge get other noise.
Image<Rgba8> moved_left(const Image<Rgba8>& left, int d, std::uint64_t seed, int most = 255);

// Matches two pictures that are valid input; single-threaded, and with the same result on every
// instruction set.
views::DenseMatch matched(const Image<Rgba8>& left, const Image<Rgba8>& right,
                          const views::MatchSettings& settings);

// The named settings with this range, but without steps after the matching itself: no filling, no
// median.
views::MatchSettings plain_settings(const char* name, views::DisparityRange range);

}  // namespace glassbox::study
