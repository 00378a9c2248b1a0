// The same with several samples to a pixel: depth tested and stored for each, shaded once for each pixel and triangle.
#pragma once

#include <glassbox/render/staged/fragments.h>

namespace glassbox {

// FragmentStage::samples is there. A triangle's fragments write to the samples, and to the planes of pixel centres.
void rasterise_samples(const FragmentStage& stage, const ReadyTriangle& triangle);

// Lines and points write to the samples alone: those of a rectangle one pixel wide around the line, with square ends, and of
// the unit square around the point. (Which pixel centres they have does not depend on samples: fragments.h.)
void rasterise_samples(const FragmentStage& stage, const ReadyLine& line);
void rasterise_samples(const FragmentStage& stage, const ReadyPoint& point);

}  // namespace glassbox
