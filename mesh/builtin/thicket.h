// Leaves that are cut out of rectangles by the alpha of their image.
#pragma once

#include <glassbox/mesh/scene.h>

namespace glassbox {

// 240 twigs of 40 leaves each, one behind the other as far as 16 units from the eye, seen from both sides. What hides what is
// known only once an image has been looked at: a rasterizer's masks.
Scene make_thicket();

}  // namespace glassbox
