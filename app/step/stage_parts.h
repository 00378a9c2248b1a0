// The parts of which the texts of a triangle's stages are made (triangle_stages.cpp), by file. The triangle is drawn: it has an
// area as modelled.
#pragma once

#include <string>

#include "app/step/stepped_triangle.h"

namespace glassbox::app {

// ---- camera_text.cpp: the matrices between object and clip space, with their factors and the parameters they come from ----

// World from object: the product of the nodes on the way from the root.
std::string model_factors_text(const Scene& scene, const Instance& instance);
// Eye from world: where the eye stands, its axes, and by how much another formulation differs from the usual matrix.
std::string view_factors_text(const SteppedTriangle& stepped);
// Clip from eye: the lens, the entries that follow from it, and the same in two steps.
std::string projection_factors_text(const SteppedTriangle& stepped);
// The one matrix that the run multiplies with.
std::string composed_text(const TracedDraw& draw, const DrawBounds& bounds);

// ---- clipping_text.cpp ----

// How far the corners lie inside of each plane, and what clipping made of the triangle.
std::string clipping_text(const SteppedTriangle& stepped, const StepTarget& target);

// ---- singular_text.cpp ----

// The corners asked for, as far as they are in front of the eye, by the slides' projections without depth: by the singular
// projection onto the near plane, or for a parallel view by diag(1, 1, 0, 1). What these draw, and what they lose (S3-09, S4-06,
// S4-07).
std::string singular_text(const SteppedTriangle& stepped, const StepTarget& target);

// ---- fragment_text.cpp ----

// One fragment, from its edge functions to the bytes in the picture.
std::string fragment_text(const SteppedTriangle& stepped, const TracedFragment& traced, bool bits);

}  // namespace glassbox::app
