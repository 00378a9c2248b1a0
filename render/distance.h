// How far away a fragment is.
#pragma once

#include <glassbox/pipeline/view.h>

namespace glassbox {

// Along the gaze, in world units: w itself for a perspective view; for a parallel one, between its planes.
inline float distance_along_gaze(const View& view, float depth, float inverse_w) {
  if (view.perspective) return 1.0f / inverse_w;
  const double from_near =
      view.depth_range == DepthRange::kReversed ? 1.0 - double(depth) : double(depth);
  return float(view.near + from_near * (view.far - view.near));
}

}  // namespace glassbox
