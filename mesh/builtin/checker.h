// A checkered floor to the horizon, which shows the effect of minification on a texture.
#pragma once

#include <glassbox/mesh/scene.h>

namespace glassbox {

// The floor is an unlit square of 4096 x 4096 units with checks of 1 unit; the eye is 1.5 units
// above it and looks horizontally.
Scene make_checker();

}  // namespace glassbox
