// The alpha channel of a picture that may have none.
#pragma once

#include <glassbox/images/stored_image.h>

namespace glassbox {

inline bool has_alpha(int channels) {
  return channels % 2 == 0;
}

// Whether every alpha is the largest one: 255, 65535, or 1 for floats. False without alpha.
bool is_opaque(const StoredImage& image);

// The picture without its alpha channel. It must have one.
StoredImage without_alpha(const StoredImage& image);

}  // namespace glassbox
