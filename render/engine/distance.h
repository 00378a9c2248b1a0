// How far away a fragment is.
#pragma once

#include <algorithm>
#include <limits>

#include <glassbox/pipeline/formulas.h>
#include <glassbox/pipeline/view.h>

namespace glassbox {

// Along the gaze, in world units: w itself for a perspective view; for a parallel one, between its planes. Never infinite, as where
// nothing is seen: the reciprocal of the largest float is subnormal, rounds to 2^-128, and that one's overflows.
inline float distance_along_gaze(const View& view, float depth, float inverse_w) {
  if (view.perspective) return std::min(1.0f / inverse_w, std::numeric_limits<float>::max());
  return parallel_distance(depth, view.depth_range == DepthRange::kReversed, view.near, view.far);
}

}  // namespace glassbox
