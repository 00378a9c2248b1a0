// Pairs whose every disparity is known because they were made so.
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

struct NamedSettings {
  std::string name;
  MatchSettings settings;
};

// One of each way to the winners: by volumes, by the sweep in bytes, each pixel for itself, and by the single sweep in 16 bits of other
// costs and of more paths than bytes have room for.
inline std::vector<NamedSettings> every_way(const DisparityRange& range) {
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
