// Shows quantities as pictures (render --show).
#pragma once

#include <glassbox/render/engine/framebuffer.h>

namespace glassbox {

// Replaces the colours by a picture of another image of the framebuffer:
//   kDepth      grey, white at the smallest distance drawn, dark grey at the largest
//   kId         one colour per triangle, neighbouring numbers far apart in hue
//   kOverdraw   how many fragments were written: 1 dark blue ... 8 and more white
// Pixels where nothing was drawn keep the background. For kColor, kNormal and kUv nothing is done,
// because the fragments have already been drawn in the right colours.
void show_plane(Show what, Framebuffer& buffers);

}  // namespace glassbox
