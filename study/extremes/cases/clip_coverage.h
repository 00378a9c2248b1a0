// From clip space to covered pixels, with a clipper under judgement.
#pragma once

#include <functional>

#include <glassbox/pipeline/viewport.h>
#include <glassbox/raster/stages.h>

#include "study/extremes/cases/clip_case.h"

namespace glassbox::study {

// Divides, snaps and sets up what the clipper leaves, and visits the pixels that it covers. Vertices must be within the
// guard band.
void visit_covered(const Outline& outline, const Viewport& viewport, const PixelRect& window,
                   const std::function<void(int x, int y)>& visit);

}  // namespace glassbox::study
