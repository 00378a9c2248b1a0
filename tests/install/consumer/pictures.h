// A picture of each type that the matchers take from the library, each of another size.
#pragma once

#include <cstdint>
#include <vector>

#include <glassbox/compare/testing/golden.h>
#include <glassbox/images/image.h>
#include <glassbox/images/stored_image.h>
#include <glassbox/images/write.h>

inline glassbox::Image<glassbox::Rgba8> colours() {
  return {7, 5, {10, 20, 30, 40}};
}

inline glassbox::StoredImage stored() {
  return {6, 4, 1, std::vector<std::uint16_t>(6 * 4, 1000)};
}

inline glassbox::PictureView view() {
  static const float samples[3 * 2] = {0, 1, 2, 3, 4, 5};
  return {3, 2, 1, samples};
}

// Writes the file, too.
inline glassbox::PictureFile file() {
  glassbox::PictureFile made{"made.png"};
  if (!glassbox::write_image(made.path, colours())) made.path += ": cannot be written";
  return made;
}
