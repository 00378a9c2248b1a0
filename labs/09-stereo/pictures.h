// The expected answers for anaglyphs: by the composition of images/stereo, and by exact rationals.
#pragma once

#include "labs/09-stereo/cases.h"
#include "labs/framework/lab.h"

namespace glassbox::labs {

Case expect_anaglyph(const lab_09::AnaglyphCase& input);
Case expect_colour(const lab_09::ColourCase& input);

}  // namespace glassbox::labs
