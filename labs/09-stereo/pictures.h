// The expected answers for anaglyphs: pictures combined by images/stereo, and colours computed in
// decimal numbers of 50 digits.
#pragma once

#include "labs/09-stereo/generators.h"
#include "labs/framework/lab.h"

namespace glassbox::labs {

Case expect_anaglyph(const lab_09::AnaglyphCase& input);
Case expect_colour(const lab_09::ColourCase& input);

// Generated inputs.
Case expect_any_anaglyph(const lab_09::AnaglyphCase& input);
bool right_anaglyph(const lab_09::AnaglyphCase& input, const Answer& answer);
bool right_colour(const lab_09::ColourCase& input, const Answer& answer);

}  // namespace glassbox::labs
