// Rounds positions on the screen to integers (1/256 pixel).
#pragma once

#include <glassbox/pipeline/stages.h>
#include <glassbox/raster/formulas.h>
#include <glassbox/raster/stages.h>

namespace glassbox {

// Requires |position| < 2^16 pixels (SnappedVertex), which clipping to the guard band guarantees.
inline SnappedVertex snap(const ScreenVertex& vertex) {
  return {snap(vertex.position.x), snap(vertex.position.y)};
}

}  // namespace glassbox
