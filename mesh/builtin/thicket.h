// Leaves that are cut out of rectangles by the alpha of their image.
#pragma once

#include <glassbox/mesh/scene.h>

namespace glassbox {

// 240 twigs of 40 leaves each, one behind the other up to 16 units from the eye; both sides of a
// leaf are visible. Which leaf hides which is known only after the image's alpha has been read: a
// test for a rasterizer with alpha masks.
Scene make_thicket();

}  // namespace glassbox
