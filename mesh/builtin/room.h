// A furnished room, seen from inside.
#pragma once

#include <glassbox/mesh/scene.h>

namespace glassbox {

// The room is 6 wide, 3 high and 5 deep, and its walls face inwards. It has boards on the floor,
// wallpaper, a window in the far wall, a table, two stools and a shelf, and is lit by a lamp over
// the table.
Scene make_room();

}  // namespace glassbox
