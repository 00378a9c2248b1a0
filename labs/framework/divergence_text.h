// The numbers of a divergence in words.
#pragma once

#include <string>

#include "labs/framework/lab.h"

namespace glassbox::labs {

// What is expected, and what came: with the digits that tell floats apart, and all of a double where these are the same for both. An
// expected number that cannot be told from 0 within the bound is 0.
std::string expected_text(const Divergence& found);
std::string actual_text(const Divergence& found);

// "1 world units, 8388608 float ulps; at most 1e-06 is allowed". Of what is counted, indices and names given as numbers, there are
// no ulps.
std::string distance_text(const Divergence& found);

}  // namespace glassbox::labs
