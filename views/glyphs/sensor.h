// What a camera does to the light before a picture is one: a lens that bends and darkens, colour filters in a mosaic, and noise
// (SPEC S1-27).
#pragma once

#include <cstdint>

#include <glassbox/images/image.h>

namespace glassbox::views {

struct Sensor {
  // At the distance r from the middle, in halves of the picture's height, is what belongs at r (1 + bend r^2): more than 0 is a barrel.
  double bend = 0;
  // Of the light at the corners, what is lost; as the square of the distance.
  double falloff = 0;
  // Each pixel has one colour, by rows red and green, green and blue (Bayer); what it lacks is the mean of its neighbours that have it.
  bool has_mosaic = false;
  // Electrons that white frees: a pixel of n of them is off by sqrt(n) (Poisson's law, as a normal one). 0: none counts them.
  double electrons = 0;
};

// In this order; into 8 bits of sRGB.
Image<Rgba8> through_sensor(const Image<Rgba8>& picture, const Sensor& sensor, std::uint64_t seed);

}  // namespace glassbox::views
