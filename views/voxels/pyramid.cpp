#include "views/voxels/pyramid.h"

#include <algorithm>

namespace glassbox::views {

namespace {

// The indices of those pixels of the finer picture that are covered by one pixel of the coarser
// picture and are not background: at most four, and fewer at the end of a picture of odd size.
struct PixelBlock {
  std::size_t at[4];
  int count = 0;
};

PixelBlock block_of(const PackedPicture& picture, int x, int y) {
  PixelBlock block;
  for (int row = 2 * y; row <= std::min(2 * y + 1, picture.height - 1); ++row) {
    for (int column = 2 * x; column <= std::min(2 * x + 1, picture.width - 1); ++column) {
      const std::size_t at = std::size_t(row) * std::size_t(picture.width) + std::size_t(column);
      if ((picture.words[at] & kBackground) == 0) block.at[block.count++] = at;
    }
  }
  return block;
}

std::uint32_t mean_word(const PackedPicture& picture, const PixelBlock& block) {
  if (block.count == 0) return kBackground;
  std::uint32_t sums[3] = {0, 0, 0};
  for (int i = 0; i < block.count; ++i) {
    const auto channels = channels_of(picture.words[block.at[i]]);
    for (std::size_t k = 0; k < 3; ++k) sums[k] += channels[k];
  }
  std::uint32_t mean = 0;
  const auto count = std::uint32_t(block.count);
  for (int k = 0; k < 3; ++k) mean |= (sums[k] + count / 2) / count << (kChannelBits * k);
  return mean;
}

// The deviation around a pixel of the coarser picture is taken to be the mean of the deviations
// around the finer pixels that it covers.
std::uint32_t mean_spread(const PackedPicture& picture, const PixelBlock& block) {
  std::uint32_t sum = 0;
  for (int i = 0; i < block.count; ++i) sum += picture.spread[block.at[i]];
  return block.count == 0 ? 0 : sum / std::uint32_t(block.count);
}

Rgba8 mean_rgb(const PackedPicture& picture, const PixelBlock& block) {
  int r = 0, g = 0, b = 0;
  for (int i = 0; i < block.count; ++i) {
    const Rgba8& pixel = picture.rgb[block.at[i]];
    r += pixel.r;
    g += pixel.g;
    b += pixel.b;
  }
  const int count = std::max(block.count, 1);
  return {std::uint8_t(r / count), std::uint8_t(g / count), std::uint8_t(b / count), 255};
}

}  // namespace

PackedPicture half_size(const PackedPicture& picture) {
  PackedPicture half;
  half.pixel_from_world = picture.pixel_from_world;
  half.pixel_from_world.topRows<2>() /= 2;
  half.eye = picture.eye;
  half.shows_whole_object = picture.shows_whole_object;
  half.width = (picture.width + 1) / 2;
  half.height = (picture.height + 1) / 2;
  half.words.reserve(std::size_t(half.width) * std::size_t(half.height));
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      const PixelBlock block = block_of(picture, x, y);
      half.words.push_back(mean_word(picture, block));
      if (!picture.spread.empty()) half.spread.push_back(mean_spread(picture, block));
      if (!picture.rgb.empty()) half.rgb.push_back(mean_rgb(picture, block));
    }
  }
  return half;
}

}  // namespace glassbox::views
