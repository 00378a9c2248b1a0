// Which prototype a colour is: the nearest one, if it is near enough (SPEC S1-28).
#pragma once

#include <Eigen/Core>

#include <glassbox/images/image.h>

#include "views/glyphs/code.h"

namespace glassbox::views {

// Light, 1 for white paper, in red, green and blue.
using Light = Eigen::Array3f;

Light light_of(const Rgba8& color);

inline constexpr int kNoPrototype = -1;

// The nearest prototype of a colour as displayed (codes, 0 .. 255), if its distance is less than `threshold` times the prototype's own
// to its nearest other one: the slides' 0.4, "1/T^2 = 6.0". Of an infinite threshold the nearest one whatever.
int prototype_of(const Eigen::Array3f& codes, float threshold);

// Light to codes that are displayed, without rounding.
Eigen::Array3f codes_of(const Light& light);

// The colour of the paper: the medians of red, green and blue of those pixels whose darkest channel is at least 0.8 of what it is in
// all but 5 % of them. Light, not codes.
Light paper_of(const Image<Rgba8>& picture);

}  // namespace glassbox::views
