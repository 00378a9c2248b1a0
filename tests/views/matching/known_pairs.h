// Pairs of pictures that are made from known disparities.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/images/image.h>

#include "views/matching/settings.h"

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

// The right camera's picture of a wall at disparity d: right(x - d) = left(x); the strip at the
// edge is filled with noise.
inline Image<Rgba8> moved_left(const Image<Rgba8>& left, int d, std::uint64_t seed) {
  Image<Rgba8> right = noise(left.width, left.height, seed);
  for (int y = 0; y < left.height; ++y) {
    for (int x = std::max(0, d); x < std::min(left.width, left.width + d); ++x) {
      right.at(x - d, y) = left.at(x, y);
    }
  }
  return right;
}

struct NamedSettings {
  std::string name;
  MatchSettings settings;
};

// Settings for each way to compute the winners: by volumes, by the sweep in bytes, for each pixel
// alone, and by the single sweep in 16 bits for other costs and for more paths than fit in bytes.
inline std::vector<NamedSettings> settings_of_every_path(const DisparityRange& range) {
  std::vector<NamedSettings> all;
  for (const char* name : {"default", "fast", "winner"})
    all.push_back({name, *settings_named(name)});
  const MatchSettings fast = *settings_named("fast");
  all.push_back({"fast, ad-census", fast});
  all.back().settings.cost = MatchingCost::kAdCensus;
  all.push_back({"fast, 8 paths", fast});
  all.back().settings.paths = 8;
  for (NamedSettings& one : all) one.settings.range = range;
  return all;
}

}  // namespace glassbox::views
