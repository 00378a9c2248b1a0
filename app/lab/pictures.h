// Pictures of what is expected, what came and where they differ.
#pragma once

#include <string>
#include <vector>

#include "labs/framework/lab.h"

#include <glassbox/images/image.h>

namespace glassbox::app {

struct CoveragePictures {
  Image<Rgba8> expected, actual, difference;
};

// Light where there is most. In the difference what is right stays grey, what is missing is red, what is covered too often
// orange, and what should be empty and is not, blue.
CoveragePictures coverage_pictures(const labs::Expected& expected,
                                   const std::vector<double>& actual);

// An SVG of two polygons, x to the right and y up, after the division by w where there is one: what is expected filled, what came
// as a dashed outline. Empty where neither can be drawn.
std::string polygon_drawing(const labs::Expected& expected, const std::vector<double>& actual);

}  // namespace glassbox::app
