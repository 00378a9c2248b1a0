// Pairs whose every disparity is known because they were made so.
#pragma once

#include <algorithm>

#include <glassbox/base/random.h>
#include <glassbox/images/image.h>

namespace glassbox::views {

inline Image<Rgba8> noise(int width, int height, std::uint64_t seed) {
  Random random(seed);
  Image<Rgba8> image(width, height);
  for (Rgba8& pixel : image.pixels) {
    const auto channel = [&] { return std::uint8_t(random.integer(0, 255)); };
    pixel = {channel(), channel(), channel(), 255};
  }
  return image;
}

// What the right camera sees of a wall at disparity d: right(x - d) = left(x); what comes in at the edge is noise.
inline Image<Rgba8> moved_left(const Image<Rgba8>& left, int d, std::uint64_t seed) {
  Image<Rgba8> right = noise(left.width, left.height, seed);
  for (int y = 0; y < left.height; ++y) {
    for (int x = std::max(0, d); x < std::min(left.width, left.width + d); ++x) {
      right.at(x - d, y) = left.at(x, y);
    }
  }
  return right;
}

}  // namespace glassbox::views
