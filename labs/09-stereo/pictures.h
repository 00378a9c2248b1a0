// The expected answers for anaglyphs: pictures of the nearest fragments, and colours computed in
// decimal numbers of 50 digits.
#pragma once

#include "labs/09-stereo/generators.h"
#include "labs/framework/lab.h"

namespace glassbox::labs {

Case expect_anaglyph(const lab_09::AnaglyphCase& input);
Case expect_colour(const lab_09::ColourCase& input);

// Generated inputs.
bool right_anaglyph(const lab_09::AnaglyphCase& input, const Answer& answer);
bool right_colour(const lab_09::ColourCase& input, const Answer& answer);

}  // namespace glassbox::labs
