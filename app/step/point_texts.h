// The parts of the text about points, by source file.
#pragma once

#include <optional>
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
std::string vertex_verdict_text(const PointStep::Walk& walk, const PointStep& step);

// ---- point_precision.cpp ----

// The bound of the error of the position in the window, px: rounding, and the digits of the printed
// matrices. 0 if the point has no position there.
double uncertainty_px(const PointStep::Walk& walk);

// The distance along the gaze, and how well the depth gives it; nothing if the projection's depth
// does not tell distances. The point must have a position in the window.
struct KnownDistance {
  double distance = 0, uncertainty = 0;
};
std::optional<KnownDistance> known_distance(const PointStep::Walk& walk, const PointStep& step);

// What cannot be said because of these errors, and what helps; empty if they are small.
std::string imprecision_text(const PointStep::Walk& walk, const PointStep& step);
std::string imprecision_remedy(const PointStep::Walk& walk);

// ---- point_verdict_text.cpp ----

// "(0, 0, 0) is visible at (300.00, 200.00)"
std::string where_sentence(const PointStep::Walk& walk, const PointStep& step);

// The matrix that a finding is about, "view: "; empty if it is about all.
std::string finding_place(const Finding& finding);

}  // namespace glassbox::app
