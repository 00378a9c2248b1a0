// The slides' ways to the two matrices of a camera in words: their factors, and what they differ by from the usual ones.
#pragma once

#include <string>

#include "app/step/stepped.h"

namespace glassbox::app {

// Eye from world by moving, turning and rolling.
std::string axis_angle_text(const Camera& camera, const View& view);

// Which entries of clip_from_eye follow from what, for the forms other than kPerspective.
std::string entries_text(const View& view, ProjectionForm form);

// A perspective matrix in two steps: any pyramid to the regular one, the regular one to the box. Empty for parallel views.
std::string two_steps_text(const View& view);

// By how much the matrices differ from those of the usual formulation; empty where they are those.
std::string view_difference_text(const SteppedTriangle& stepped);
std::string projection_difference_text(const SteppedTriangle& stepped);

}  // namespace glassbox::app
