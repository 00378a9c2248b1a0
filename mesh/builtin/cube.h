// A cube of side 2 about the origin, with a different colour on each face.
#pragma once

#include <glassbox/mesh/scene.h>

namespace glassbox {

Scene make_cube();

}  // namespace glassbox
