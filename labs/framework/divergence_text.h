// Describes the numbers of a divergence in words.
#pragma once

#include <string>

#include "labs/framework/lab.h"

namespace glassbox::labs {

// The expected number and the actual one, with the digits that tell floats apart, or all digits of
// a double where these are the same for both. An expected number that is within the bound of 0 is
// shown as 0.
std::string expected_text(const Divergence& found);
std::string actual_text(const Divergence& found);

// "1 world units, 8388608 float ulps; at most 1e-06 is allowed". Counts, indices and names given as
// numbers have no ulps.
std::string distance_text(const Divergence& found);

}  // namespace glassbox::labs
