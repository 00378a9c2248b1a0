// Clip space to NDC: the perspective divide (S4-08).
#pragma once

#include <glassbox/pipeline/stages.h>

namespace glassbox {

// x/w, y/w, z/w and 1/w, each rounded once. Multiplying by 1/w would round twice and be wrong by an ulp now and then.
//
// w = 1, a parallel projection, is left alone: the bits are the same as those of a division, and a plan may leave the
// stage out. Any w that is not zero will do, negative ones too (vertices that are only looked at, before clipping);
// after clipping by render_planes() w is at least near/2.
inline NdcVertex divide(const Point<Clip>& clip) {
  if (clip.w == 1) return {{clip.x, clip.y, clip.z}, 1};
  return {{clip.x / clip.w, clip.y / clip.w, clip.z / clip.w}, 1 / clip.w};
}

inline NdcVertex divide(const ClipVertex& clip) {
  return divide(clip.position);
}

}  // namespace glassbox
