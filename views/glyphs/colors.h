// Finds the prototype of a colour: the nearest of the six colours that glyphs are made of
// (glyph_code.h), if it is near enough (S1-28).
#pragma once

#include <Eigen/Core>

#include <glassbox/images/image.h>

#include "views/glyphs/glyph_code.h"

namespace glassbox::views {

// Linear light in red, green and blue; 1 is white paper.
using Light = Eigen::Array3f;

Light light_of(const Rgba8& color);

inline constexpr int kNoPrototype = -1;

// The index of the prototype that is nearest to a displayed colour (codes, 0 .. 255), if its
// distance from the colour is less than `threshold` times its distance from the nearest other
// prototype; else kNoPrototype. The slides' threshold T is 0.4, "1/T^2 = 6.0". With an infinite
// threshold the result is always the nearest prototype.
int prototype_of(const Eigen::Array3f& codes, float threshold);

// Converts light to display codes, without rounding.
Eigen::Array3f codes_of(const Light& light);

// The colour of the paper as light, not codes: the medians of red, green and blue over the
// brightest pixels. These are the pixels whose darkest channel is at least 0.8 of the value that
// only 5 % of the pixels exceed.
Light paper_of(const Image<Rgba8>& picture);

}  // namespace glassbox::views
