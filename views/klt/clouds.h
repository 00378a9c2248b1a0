// A generated planet seen at five wavelengths, in place of the slides' pictures from a weather
// satellite (S1-14).
#pragma once

#include <glassbox/images/image.h>

#include "views/klt/bands.h"

namespace glassbox::views {

struct CloudScene {
  Bands bands;                  // numbers of ten bits (counts), 0 .. 1023, like the satellite's
  Image<Rgba8> ground;          // land and sea, as they look without clouds
  std::vector<double> opacity;  // of the clouds, 0 .. 1: a component of the bands should show it
};

inline constexpr int kCloudWidth = 512, kMaxCloudWidth = 4096, kCloudBands = 5;

// The whole planet without seams: longitude across and latitude down, `width` x `width` / 2 px.
// There are one band of visible light and four infrared bands (3.9, 6.7, 10.7 and 12 micrometres).
// They are computed from four things that vary independently: opacity and height of the clouds,
// moisture, and the kind of ground. Each sample has noise of 0.5 to 3 counts. The numbers are the
// same on every machine.
CloudScene make_clouds(int width = kCloudWidth);

}  // namespace glassbox::views
