// A thick letter F, which looks different after any mirroring or quarter turn: it makes mirrored
// pictures visible.
#pragma once

#include <glassbox/mesh/scene.h>

namespace glassbox {

// The letter is 3 wide, 5 high and 1 deep, with its lowest corner at (0, 0, 0); it reads correctly
// when seen from +z. Its front (yellow) and back (blue) are concave polygons of ten corners; the
// sides are quads. The surface is closed.
Scene make_f_glyph();

}  // namespace glassbox
