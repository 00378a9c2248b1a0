// A corner with a scale and a direction, and what its surroundings look like.
#pragma once

#include <array>
#include <cstdint>

namespace glassbox::views {

struct Feature {
  double x = 0, y = 0;  // px of the picture, from its top left corner
  double scale = 1;     // px of the picture for one pixel of the level where it was found
  double angle = 0;     // radians from the x axis towards the y axis (clockwise, as y is down)
  double strength = 0;  // the response at its level
};

// Features are at least this many pixels of their level away from the level's edges. No descriptor
// reads beyond it: the farthest sample is that of a SIFT gradient, 2.5 sqrt(2) cells of 4 px and
// one pixel away.
inline constexpr int kFeatureMargin = 16;

enum class Description {
  kNcc,   // grey levels of a window (window_descriptor.h)
  kOrb,   // comparisons of pairs of grey levels (bit_descriptor.h)
  kSift,  // histograms of gradients (gradient_descriptor.h)
};
inline constexpr Description kDescriptions[] = {Description::kNcc, Description::kOrb,
                                                Description::kSift};
const char* name_of(Description description);

}  // namespace glassbox::views
