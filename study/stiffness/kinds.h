// The texts for each condition number, independent of the scene: its name, the formula and source
// of its bound, and advice.
#pragma once

#include "study/stiffness/stiffness.h"

namespace glassbox::study {

enum class StiffKind { kDepth, kInverseW, kDivide, kOffset, kSliver, kTexcoord, kUp };

// Returns the texts only: condition, bound and place are not set yet.
StiffNumber number_of(StiffKind kind);

}  // namespace glassbox::study
