// The slides' projections without depth: what they draw, and what they lose (S3-09, S4-06, S4-07).
#pragma once

#include <string>

#include "app/step/stepped.h"

namespace glassbox::app {

// The corners asked for, as far as they are in front of the eye, by the singular projection onto the near plane; of a
// parallel view by diag(1, 1, 0, 1).
std::string singular_text(const SteppedTriangle& stepped, const StepTarget& target);

}  // namespace glassbox::app
