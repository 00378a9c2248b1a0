// A small renderer in place of a user's own: it draws a disc on a grey gradient.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>

#include <glassbox/images/image.h>

inline glassbox::Image<glassbox::Rgba8> render_disc() {
  glassbox::Image<glassbox::Rgba8> image(96, 64);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const int dx = x - 48, dy = y - 32;
      const auto grey = std::uint8_t(2 * x);
      image.at(x, y) = dx * dx + dy * dy < 400 ? glassbox::Rgba8{220, 80, 40}
                                               : glassbox::Rgba8{grey, grey, grey};
    }
  }
  // A defect on request, to see the message of a failing test: one wrong pixel.
  if (std::getenv("PLANT_A_DEFECT") != nullptr) image.at(60, 20).g ^= 1;
  return image;
}

// Distances of a rectangle, with infinity in the pixels of the background.
inline glassbox::Image<float> render_distances() {
  glassbox::Image<float> image(96, 64, HUGE_VALF);
  for (int y = 20; y < 40; ++y) {
    for (int x = 30; x < 60; ++x) image.at(x, y) = 1.0f + float(x) / 64;
  }
  return image;
}
