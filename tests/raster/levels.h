// Converts between textures and images of their levels.
#pragma once

#include <cstdint>
#include <vector>

#include <glassbox/images/image.h>
#include <glassbox/raster/texture.h>

namespace glassbox::test {

inline std::vector<Image<Texel>> levels_of(const MipChain& chain) {
  std::vector<Image<Texel>> levels;
  int width = chain.width, height = chain.height;
  for (const std::int32_t first : chain.first) {
    Image<Texel>& level = levels.emplace_back(width, height);
    for (std::size_t i = 0; i < level.pixels.size(); ++i) {
      level.pixels[i] = chain.texels.at(std::size_t(first) + i);
    }
    width = width > 1 ? width / 2 : 1;
    height = height > 1 ? height / 2 : 1;
  }
  return levels;
}

// A texture of these levels; each has half the width and height of the one before.
inline MipChain chain_of(const std::vector<Image<Texel>>& levels) {
  MipChain chain{levels.front().width, levels.front().height, {}, {}};
  for (const Image<Texel>& level : levels) {
    chain.first.push_back(std::int32_t(chain.texels.size()));
    chain.texels.insert(chain.texels.end(), level.pixels.begin(), level.pixels.end());
  }
  return chain;
}

}  // namespace glassbox::test
