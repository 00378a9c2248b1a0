// Describes the numbers of a divergence in words.
#pragma once

#include <string>

#include "labs/framework/lab.h"

namespace glassbox::labs {

// The expected number and the actual one, with the 9 digits that tell floats apart, or with the 17
// digits of a double if the 9 digits are the same for both numbers. An expected number that is
// within the bound of 0 is shown as 0.
std::string expected_text(const Divergence& found);
std::string actual_text(const Divergence& found);

// How far the answer is off: "1 world units, 8388608 float ulps; at most 1e-06 is allowed". Counts,
// indices and names given as numbers have no ulps.
std::string distance_text(const Divergence& found);

}  // namespace glassbox::labs
