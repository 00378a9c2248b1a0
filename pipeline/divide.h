// Clip space to NDC: the perspective divide (S4-08).
#pragma once

#include <glassbox/pipeline/stages.h>

namespace glassbox {

// x/w, y/w, z/w and 1/w, each rounded once. Multiplying by 1/w would round twice, and the result
// would sometimes be wrong by an ulp.
//
// For w = 1, a parallel projection, nothing is divided: the bits are the same as those of a
// division, so this stage may be left out. Any w that is not zero is allowed, also a negative one
// (for vertices that are inspected before clipping). After clipping by render_planes() w is at
// least near/2.
inline NdcVertex divide(const Point<Clip>& clip) {
  if (clip.w == 1) return {{clip.x, clip.y, clip.z}, 1};
  return {{clip.x / clip.w, clip.y / clip.w, clip.z / clip.w}, 1 / clip.w};
}

inline NdcVertex divide(const ClipVertex& clip) {
  return divide(clip.position);
}

}  // namespace glassbox
