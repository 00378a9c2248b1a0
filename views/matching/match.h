// Dense matching from two pictures to a disparity map: the steps of this folder, one after the other.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

#include "views/matching/cost_volume.h"
#include "views/matching/filters.h"
#include "views/matching/settings.h"

namespace glassbox::views {

struct MatchStep {
  std::string name;
  double milliseconds = 0;
};

struct DenseMatch {
  Image<float> disparity;   // px, of the left picture; kNoDisparity where there is none
  Image<float> confidence;  // peak ratio, [0, 1]
  Image<Doubt> doubts;      // before holes were filled
  CostVolume sums;          // that the winners were sought in, where they were to be kept
  std::vector<MatchStep> steps;
  std::uint64_t bytes = 0;  // of the volumes
};

// What the volumes of such a match take, in bytes: 2 for the cost of each pixel and disparity, and 4 more for the sums along paths,
// with the disparities filled up to a multiple of 32; of a single sweep some rows of each band.
std::uint64_t bytes_of_match(int width, int height, const MatchSettings& settings);

// Both pictures are of one size, and rectified: a point is on the same row of both. Pixels of alpha 0 show nothing, and match
// nothing. An error where they are not of one size, the settings cannot be, or the volumes would take more than `max_bytes`: before
// anything is allocated.
Result<DenseMatch> match_pictures(const Image<Rgba8>& left, const Image<Rgba8>& right,
                                  const MatchSettings& settings,
                                  std::uint64_t max_bytes = std::uint64_t(4) << 30);

}  // namespace glassbox::views
