// How far away a fragment is.
#pragma once

#include <glassbox/pipeline/formulas.h>
#include <glassbox/pipeline/view.h>

namespace glassbox {

// Along the gaze, in world units: w itself for a perspective view; for a parallel one, between its planes.
inline float distance_along_gaze(const View& view, float depth, float inverse_w) {
  if (view.perspective) return 1.0f / inverse_w;
  return parallel_distance(depth, view.depth_range == DepthRange::kReversed, view.near, view.far);
}

}  // namespace glassbox
