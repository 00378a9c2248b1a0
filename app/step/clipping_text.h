// Stage 5 of a stepped triangle: how far its corners lie inside of each plane, and what clipping made of it.
#pragma once

#include <string>

#include "app/step/stepped.h"

namespace glassbox::app {

// The triangle is there.
std::string clipping_text(const SteppedTriangle& stepped, const StepTarget& target);

}  // namespace glassbox::app
