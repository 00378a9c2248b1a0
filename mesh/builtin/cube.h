// A cube of side 2 about the origin, each face in a colour of its own.
#pragma once

#include <glassbox/mesh/scene.h>

namespace glassbox {

Scene make_cube();

}  // namespace glassbox
