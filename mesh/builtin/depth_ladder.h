// Twenty pairs of nearly coplanar squares, each pair twice as far away as the one before. They show
// up to which distance a depth format can separate the front square from the back one.
#pragma once

#include <glassbox/mesh/scene.h>

namespace glassbox {

// The rungs are at the distances 1, 2, 4 .. 2^19 along the gaze and fill a grid of 5 columns and 4
// rows in the picture, starting at its top left. In each, a smaller green square is in front of a
// red one, nearer by a 1024th of the distance. The red ones are drawn first and win ties, so red
// over green is a visible failure of the depth buffer. The near plane is at 1/2, the far one at
// 2^20.
Scene make_depth_ladder();

}  // namespace glassbox
