// A furnished room, seen from inside.
#pragma once

#include <glassbox/mesh/scene.h>

namespace glassbox {

// 6 wide, 3 high, 5 deep, facing inwards, with boards on the floor, wallpaper, a window in the far
// wall, a table, two stools and a shelf; lit by a lamp over the table.
Scene make_room();

}  // namespace glassbox
