// Twenty pairs of nearly coplanar squares, each pair twice as far away as the one before. They show
// up to which distance a depth format can separate the front square from the back one.
#pragma once

#include <glassbox/mesh/scene.h>

namespace glassbox {

// The pairs of squares (rungs) are at the distances 1, 2, 4 .. 2^19 along the direction of view and
// fill a grid of 5 columns and 4 rows in the picture, starting at its top left. In each rung a
// smaller green square is in front of a red one, nearer by a 1024th of the distance. The red
// squares are drawn first and stay where the depths are equal, so red where green should be is a
// visible failure of the depth buffer. The near plane is at 1/2, the far plane at 2^20.
Scene make_depth_ladder();

}  // namespace glassbox
