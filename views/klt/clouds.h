// A planet seen at five wavelengths, generated: what the slides took from a weather satellite (SPEC S1-14).
#pragma once

#include <glassbox/images/image.h>

#include "views/klt/bands.h"

namespace glassbox::views {

struct CloudScene {
  Bands bands;                  // counts of ten bits, 0 .. 1023, as the satellite's were
  Image<Rgba8> ground;          // land and sea, as they look without clouds
  std::vector<double> opacity;  // of the clouds, 0 .. 1: what a component of the bands should tell
};

inline constexpr int kCloudWidth = 512, kMaxCloudWidth = 4096, kCloudBands = 5;

// The whole planet, longitude across and latitude down, `width` x `width` / 2 px; without seams. Visible light and four infrared
// bands (3.9, 6.7, 10.7 and 12 micrometres) from four things that vary on their own: opacity and height of clouds, moisture, and what
// the ground is; each sample with noise of half a count to three. The same numbers on every machine.
CloudScene make_clouds(int width = kCloudWidth);

}  // namespace glassbox::views
