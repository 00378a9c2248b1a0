// The expected answers for anaglyphs: pictures combined by images/stereo, and colours computed in
// exact rational numbers.
#pragma once

#include "labs/09-stereo/cases.h"
#include "labs/framework/lab.h"

namespace glassbox::labs {

Case expect_anaglyph(const lab_09::AnaglyphCase& input);
Case expect_colour(const lab_09::ColourCase& input);

}  // namespace glassbox::labs
