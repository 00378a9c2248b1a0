// The meaning of the samples of a picture.
#pragma once

#include <glassbox/images/stored_image.h>

namespace glassbox {

inline bool has_floats(const StoredImage& image) {
  return std::holds_alternative<std::vector<float>>(image.samples);
}

// The sample value that means 1: 255, 65535, or 1 for floats.
inline double full_scale(const StoredImage& image) {
  if (std::holds_alternative<std::vector<std::uint8_t>>(image.samples)) return 255;
  if (std::holds_alternative<std::vector<std::uint16_t>>(image.samples)) return 65535;
  return 1;
}

}  // namespace glassbox
