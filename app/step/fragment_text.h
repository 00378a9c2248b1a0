// One fragment, from its edge functions to the bytes in the picture.
#pragma once

#include <string>

#include "app/step/stepped.h"

namespace glassbox::app {

std::string fragment_text(const SteppedTriangle& stepped, const TracedFragment& traced, bool bits);

}  // namespace glassbox::app
