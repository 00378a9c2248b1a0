// The texts for each condition number, independent of the scene: its name, the formula and source
// of its bound, and advice.
#pragma once

#include "study/stiffness/stiffness.h"

namespace glassbox::study {

enum class ConditionKind { kDepth, kInverseW, kDivide, kOffset, kSliver, kTexcoord, kUp };

// Returns the texts only: condition, bound and place are not set yet.
ConditionNumber condition_number_of(ConditionKind kind);

}  // namespace glassbox::study
