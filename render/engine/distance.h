// The distance of a fragment from the eye.
#pragma once

#include <algorithm>
#include <limits>

#include <glassbox/pipeline/formulas.h>
#include <glassbox/pipeline/view.h>

namespace glassbox {

// The distance along the gaze, in world units: w itself for a perspective view; for a parallel view
// it is interpolated between its planes. Never infinite, because infinity marks pixels where
// nothing is seen. (The reciprocal of the largest float is subnormal and rounds to 2^-128, and the
// reciprocal of that overflows.)
inline float distance_along_gaze(const View& view, float depth, float inverse_w) {
  if (view.perspective) return std::min(1.0f / inverse_w, std::numeric_limits<float>::max());
  return parallel_distance(depth, view.depth_range == DepthRange::kReversed, view.near, view.far);
}

}  // namespace glassbox
