// What is said of each condition number, whatever the scene: its name, the formula and source of its bound, and what to do.
#pragma once

#include "study/stiffness/stiffness.h"

namespace glassbox::study {

enum class StiffKind { kDepth, kInverseW, kDivide, kOffset, kSliver, kTexcoord, kUp };

// Without a condition, a bound or a place.
StiffNumber number_of(StiffKind kind);

}  // namespace glassbox::study
