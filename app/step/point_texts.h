// The parts of the text about points, by source file.
#pragma once

#include <string>

#include "app/step/point_step.h"

namespace glassbox::app {

// ---- point_matrices_text.cpp ----

// Describes the three matrices.
std::string matrices_text(const MatrixSetup& setup);

// An affine matrix in words: "rigid exactly: a turn by 30 degrees about (0, 1, 0), then a
// translation by (1, 2, 3)".
std::string affine_sentence(const MatrixFacts& facts);

// ---- point_walk_text.cpp ----

// Follows one point from object space to the window.
std::string walk_text(const PointStep::Walk& walk, const PointStep& step);

// Where the point is in the end: "visible at (640.00, 360.00)", "outside the near plane: its
// distance along the gaze is 0.05, and ...", "behind the eye (w = -3)"
std::string vertex_verdict_text(const VertexChain& chain, const PointStep& step);

}  // namespace glassbox::app
