// A small renderer in place of a user's own, with its own types of pictures: it draws a disc on a
// grey gradient.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include <glassbox/compare/testing/picture_view.h>

namespace renderer {

template <class Sample, int Channels>
struct Picture {
  int width, height;
  std::vector<Sample> samples;
};

using Colours = Picture<std::uint8_t, 3>;
using Distances = Picture<float, 1>;

// Tells Glassbox how such a picture lies in memory.
template <class Sample, int Channels>
glassbox::PictureView picture_view(const Picture<Sample, Channels>& picture) {
  return {picture.width, picture.height, Channels, picture.samples.data()};
}

inline Colours render_disc() {
  Colours picture{96, 64, {}};
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const int dx = x - 48, dy = y - 32;
      const auto grey = static_cast<std::uint8_t>(2 * x);
      const bool inside = dx * dx + dy * dy < 400;
      const std::uint8_t disc[] = {220, 80, 40};
      for (const std::uint8_t sample : disc) picture.samples.push_back(inside ? sample : grey);
    }
  }
  // A defect on request, to see the message of a failing test: one wrong pixel.
  if (std::getenv("PLANT_A_DEFECT") != nullptr) picture.samples[3 * (20 * 96 + 60) + 1] ^= 1;
  return picture;
}

// Distances of a rectangle, with infinity in the pixels of the background.
inline Distances render_distances() {
  Distances picture{96, 64, std::vector<float>(96 * 64, HUGE_VALF)};
  for (int y = 20; y < 40; ++y) {
    for (int x = 30; x < 60; ++x) {
      picture.samples[static_cast<std::size_t>(y * 96 + x)] = 1.0f + static_cast<float>(x) / 64;
    }
  }
  return picture;
}

}  // namespace renderer
