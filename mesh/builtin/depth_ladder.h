// Twenty pairs of nearly coplanar squares, each pair twice as far away as the one before: how far does a depth format
// tell the front one from the back one?
#pragma once

#include <glassbox/mesh/scene.h>

namespace glassbox {

// The rungs stand at the distances 1, 2, 4 .. 2^19 along the gaze and fill a grid of 5 columns and 4 rows in the
// picture, from its top left on. In each, a smaller green square stands in front of a red one, nearer by a 1024th of
// the distance. The red ones are drawn first and a tie goes to the first, so red over green is a failure of the depth
// buffer, and shows as such. The near plane is at 1/2, the far one at 2^20.
Scene make_depth_ladder();

}  // namespace glassbox
