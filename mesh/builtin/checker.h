// A checkered floor to the horizon: what minification does to a texture.
#pragma once

#include <glassbox/mesh/scene.h>

namespace glassbox {

// A square of 4096 units, checks of 1 unit, unlit; the eye stands 1.5 above it and looks level.
Scene make_checker();

}  // namespace glassbox
