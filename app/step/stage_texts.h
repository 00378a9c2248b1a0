// The parts of the texts about a triangle's stages (triangle_stages.cpp), by source file. The
// triangle must be one that is drawn: its area in object space is not zero.
#pragma once

#include <string>

#include "app/step/stepped_triangle.h"

namespace glassbox::app {

// ---- camera_text.cpp: the matrices from object to clip space, their factors and parameters ----

// world_from_object as the product of the matrices of the nodes from the root on.
std::string model_factors_text(const Scene& scene, const Instance& instance);
// eye_from_world: the eye's position and axes, and how much the chosen formulation of the matrix
// differs from the usual one.
std::string view_factors_text(const SteppedTriangle& stepped);
// clip_from_eye: the lens, the entries that follow from it, and the matrix as the product of two
// steps.
std::string projection_factors_text(const SteppedTriangle& stepped);
// The product of the three matrices (object to world, to eye, to clip), by which the vertices are
// multiplied.
std::string composed_text(const TracedDraw& draw, const DrawBounds& bounds);

// ---- clipping_text.cpp ----

// The corners' distances from each plane (positive inside), and the polygon that clipping makes of
// the triangle.
std::string clipping_text(const SteppedTriangle& stepped, const StepTarget& target);

// ---- singular_text.cpp ----

// The chosen corners that are in front of the eye, in the slides' projections without depth: the
// singular projection onto the near plane, or for a parallel view diag(1, 1, 0, 1). Shows the
// points that these projections draw, and what information is lost (S3-09, S4-06, S4-07).
std::string singular_text(const SteppedTriangle& stepped, const StepTarget& target);

// ---- fragment_text.cpp ----

// Follows one fragment from its edge functions to the bytes in the picture.
std::string fragment_text(const SteppedTriangle& stepped, const TracedFragment& traced, bool bits);

}  // namespace glassbox::app
