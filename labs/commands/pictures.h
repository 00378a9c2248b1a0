// Pictures of the expected result, the actual one, and where they differ.
#pragma once

#include <string>
#include <vector>

#include "labs/framework/lab.h"

#include <glassbox/images/image.h>

namespace glassbox::labs {

struct CoveragePictures {
  Image<Rgba8> expected, actual, difference;
};

// Pictures of how often each pixel is covered: more coverage is lighter. In the difference, correct
// pixels are grey, missing ones red, those covered too often orange, and those that should be empty
// but are not, blue.
CoveragePictures coverage_pictures(const labs::Expected& expected,
                                   const std::vector<double>& actual);

// An SVG of two polygons, x to the right and y up, after the division by w if there is one: the
// expected polygon filled, the actual one as a dashed outline. Empty if neither can be drawn.
std::string polygon_drawing(const labs::Expected& expected, const std::vector<double>& actual);

}  // namespace glassbox::labs
