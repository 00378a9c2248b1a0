// A checkered floor to the horizon, which shows the effect of minification on a texture.
#pragma once

#include <glassbox/mesh/scene.h>

namespace glassbox {

// A square of 4096 units, checks of 1 unit, unlit; the eye is 1.5 above it and looks horizontally.
Scene make_checker();

}  // namespace glassbox
