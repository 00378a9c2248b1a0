// A thick letter F, which no mirror image or quarter turn leaves alike: the figure to catch mirrored pictures with.
#pragma once

#include <glassbox/mesh/scene.h>

namespace glassbox {

// 3 wide, 5 high, 1 deep, from (0, 0, 0) on; reads right seen from +z. Front (yellow) and back (blue) are concave
// polygons of ten corners; the sides are quads. The surface is closed.
Scene make_f_glyph();

}  // namespace glassbox
