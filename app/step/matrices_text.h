// The three matrices between object and clip space, with their factors and the parameters they come from.
#pragma once

#include <string>

#include "app/step/stepped.h"

namespace glassbox::app {

// World from object: the product of the nodes on the way from the root.
std::string model_factors_text(const Scene& scene, const Instance& instance);

// Eye from world: where the eye stands, and its axes.
std::string view_factors_text(const Camera& camera, const View& view);

// Clip from eye: the lens, and the entries that follow from it.
std::string projection_factors_text(const Camera& camera, const View& view, ProjectionForm form);

// The one matrix that the run multiplies with.
std::string composed_text(const TracedDraw& draw, const DrawBounds& bounds);

}  // namespace glassbox::app
