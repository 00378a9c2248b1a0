// The distance of a fragment from the eye.
#pragma once

#include <algorithm>
#include <limits>

#include <glassbox/pipeline/formulas.h>
#include <glassbox/pipeline/view.h>

namespace glassbox {

// Returns the distance along the gaze (the direction of view), in world units. In a perspective
// view it is w; in a parallel view it is interpolated between the near and far planes. It is never
// infinite, because infinity marks pixels where nothing is seen. (Without the limit it could be: if
// w is the largest float, 1/w is subnormal and rounds to 2^-128, whose reciprocal overflows.)
inline float distance_along_gaze(const View& view, float depth, float inverse_w) {
  if (view.perspective) return std::min(1.0f / inverse_w, std::numeric_limits<float>::max());
  return parallel_distance(depth, view.depth_range == DepthRange::kReversed, view.near, view.far);
}

}  // namespace glassbox
