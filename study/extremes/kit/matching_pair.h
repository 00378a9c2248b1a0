// Rectified pairs whose every disparity is known because they were made so, and matches of them.
#pragma once

#include <cstdint>

#include <glassbox/base/random.h>

#include "views/matching/match.h"

namespace glassbox::study {

// Grey noise, 0 to `most`.
Image<Rgba8> grey_noise(int width, int height, std::uint64_t seed, int most = 255);

// What the right camera sees of a wall at disparity d, which may be negative: right(x - d) = left(x). What comes in at the edge is
// other noise.
Image<Rgba8> moved_left(const Image<Rgba8>& left, int d, std::uint64_t seed, int most = 255);

// Of pictures that can be matched; single-threaded, and the same on every instruction set.
views::DenseMatch matched(const Image<Rgba8>& left, const Image<Rgba8>& right,
                          const views::MatchSettings& settings);

// Named settings with this range, and nothing done to what the winners leave: no filling, no median.
views::MatchSettings plain_settings(const char* name, views::DisparityRange range);

}  // namespace glassbox::study
