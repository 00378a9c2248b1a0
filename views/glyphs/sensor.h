// What happens to the light inside a camera: a lens that distorts and darkens, a mosaic of colour
// filters, and noise (S1-27).
#pragma once

#include <cstdint>

#include <glassbox/images/image.h>

namespace glassbox::views {

struct Sensor {
  // Lens distortion: the image at the distance r from the middle, in halves of the picture's
  // height, is the undistorted one at r (1 + distortion r^2). Above 0 it is a barrel distortion.
  double distortion = 0;
  // The share of the light that is lost at the corners; the loss grows with the square of the
  // distance.
  double falloff = 0;
  // Each pixel measures one colour: rows alternate between red and green, and green and blue
  // (Bayer). The missing colours are the means of the neighbours that measure them.
  bool has_mosaic = false;
  // How many electrons a white pixel frees. A pixel of n electrons has a standard deviation of
  // sqrt(n) (Poisson's law, approximated by a normal distribution). 0: no noise.
  double electrons = 0;
};

// Applies the effects in this order, and converts to 8 bits of sRGB.
Image<Rgba8> apply_sensor(const Image<Rgba8>& picture, const Sensor& sensor, std::uint64_t seed);

}  // namespace glassbox::views
