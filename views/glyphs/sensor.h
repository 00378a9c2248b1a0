// What happens to the light inside a camera: a lens that distorts and darkens, a mosaic of colour
// filters, and noise (S1-27).
#pragma once

#include <cstdint>

#include <glassbox/images/image.h>

namespace glassbox::views {

struct Sensor {
  // Lens distortion: a pixel at the distance r from the picture's middle, in halves of its height,
  // shows what would be at r (1 + distortion r^2) without distortion. Above 0 it is a barrel
  // distortion.
  double distortion = 0;
  // The fraction of the light that is lost at the corners; the loss grows with the square of the
  // distance from the picture's middle.
  double falloff = 0;
  // Each pixel measures one colour: rows alternate between red and green, and green and blue
  // (Bayer). The missing colours are the means of the neighbours that measure them.
  bool has_mosaic = false;
  // How many electrons a white pixel frees. A pixel of n electrons has a standard deviation of
  // sqrt(n) (Poisson's law, approximated by a normal distribution). 0: no noise.
  double electrons = 0;
};

// Applies the effects of the lens, then the noise, then the mosaic, and converts to 8 bits of sRGB.
Image<Rgba8> apply_sensor(const Image<Rgba8>& picture, const Sensor& sensor, std::uint64_t seed);

}  // namespace glassbox::views
