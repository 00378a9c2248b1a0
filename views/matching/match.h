// Dense matching: computes a disparity map from two pictures by calling the steps of this folder
// one after the other.
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
  Image<float> disparity;   // px, for the left picture; kNoDisparity where there is none
  Image<float> confidence;  // peak ratio (settings.h), [0, 1]
  Image<InvalidReason> invalid_reasons;  // as they were before holes were filled
  // The sums that the winners were selected from, if the settings ask to keep them.
  CostVolume sums;
  std::vector<MatchStep> steps;
  std::uint64_t bytes = 0;  // memory of the cost volumes
};

// The memory in bytes for the volumes of a match: for each pixel and disparity 2 bytes for the cost
// and 4 more for the sums along paths, with the disparities padded to a multiple of 32. A single
// sweep needs only some rows for each band of rows.
std::uint64_t bytes_of_match(int width, int height, const MatchSettings& settings);

// Both pictures must have the same size and be rectified: a point is on the same row of both.
// Pixels of alpha 0 show nothing, and match nothing. An error if the sizes differ, the settings are
// invalid, or the volumes would need more than `max_bytes`; this is checked before anything is
// allocated.
Result<DenseMatch> match_pictures(const Image<Rgba8>& left, const Image<Rgba8>& right,
                                  const MatchSettings& settings,
                                  std::uint64_t max_bytes = std::uint64_t(4) << 30);

}  // namespace glassbox::views
