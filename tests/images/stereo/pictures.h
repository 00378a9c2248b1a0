// Pictures from which stereo pairs are made.
#pragma once

#include <glassbox/base/random.h>
#include <glassbox/images/image.h>

namespace glassbox::test {

// Returns a picture in which every channel, alpha too, is random from 0 to 255.
inline Image<Rgba8> noise(int width, int height, Random& random) {
  Image<Rgba8> picture(width, height);
  for (Rgba8& pixel : picture.pixels) {
    const std::uint64_t bits = random.bits();
    pixel = {std::uint8_t(bits), std::uint8_t(bits >> 8), std::uint8_t(bits >> 16),
             std::uint8_t(bits >> 24)};
  }
  return picture;
}

}  // namespace glassbox::test
