#include "views/voxels/packed_picture.h"

#include <algorithm>
#include <cmath>

#include <glassbox/images/colour/ciede2000.h>
#include <glassbox/images/srgb.h>

namespace glassbox::views {

namespace {

std::uint32_t code_of(double level) {
  return std::uint32_t(
      std::clamp(std::floor(level * kCodesPerLevel + 0.5), 0.0, double(kChannelMask)));
}

std::uint32_t word_of(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  return a | b << kChannelBits | c << (2 * kChannelBits);
}

// The deviation of the colours in the 3 x 3 pixels around each pixel. Background pixels are left
// out, because an outline is not an edge on the surface.
std::vector<std::uint32_t> spread_of(const PackedPicture& picture) {
  std::vector<std::uint32_t> spread(picture.words.size(), 0);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      ColorSums sums;
      for (int row = std::max(y - 1, 0); row <= std::min(y + 1, picture.height - 1); ++row) {
        for (int column = std::max(x - 1, 0); column <= std::min(x + 1, picture.width - 1);
             ++column) {
          const std::uint32_t word =
              picture.words[std::size_t(row) * std::size_t(picture.width) + std::size_t(column)];
          if ((word & kBackground) != 0) continue;
          add_word(sums, word);
        }
      }
      spread[std::size_t(y) * std::size_t(picture.width) + std::size_t(x)] =
          std::uint32_t(std::floor(std::sqrt(sums.variance()) + 0.5));
    }
  }
  return spread;
}

bool is_border_clear(const Image<std::uint8_t>& matte) {
  for (int x = 0; x < matte.width; ++x)
    if (matte.at(x, 0) != 0 || matte.at(x, matte.height - 1) != 0) return false;
  for (int y = 0; y < matte.height; ++y)
    if (matte.at(0, y) != 0 || matte.at(matte.width - 1, y) != 0) return false;
  return true;
}

}  // namespace

ProjectionMatrix projection_of(const PinholeCamera& camera) {
  ProjectionMatrix pose;
  pose << camera.camera_from_world, -camera.camera_from_world * camera.centre;
  return camera.intrinsic * pose;
}

std::uint32_t packed_color(const Rgba8& color, const ColoringSettings& settings) {
  if (settings.space == ColorSpace::kRgb) {
    constexpr std::uint32_t kScale = kCodesPerLevel;
    return word_of(kScale * color.r, kScale * color.g, kScale * color.b);
  }
  const Lab lab = lab_of_linear(double(decode_srgb(color.r)), double(decode_srgb(color.g)),
                                double(decode_srgb(color.b)));
  constexpr double kMiddle = 128;
  return word_of(code_of(lab.l * settings.lightness), code_of(lab.a + kMiddle),
                 code_of(lab.b + kMiddle));
}

PackedPicture pack_picture(const CalibratedPicture& picture, const ColoringSettings& settings) {
  PackedPicture packed;
  packed.pixel_from_world = projection_of(picture.camera);
  packed.eye = picture.camera.centre;
  packed.width = picture.color.width;
  packed.height = picture.color.height;
  packed.words.resize(picture.color.pixels.size());
  for (std::size_t i = 0; i < packed.words.size(); ++i) {
    const bool is_object = picture.matte.pixels.empty() || picture.matte.pixels[i] != 0;
    packed.words[i] = is_object ? packed_color(picture.color.pixels[i], settings) : kBackground;
  }
  packed.shows_whole_object = !picture.matte.pixels.empty() && is_border_clear(picture.matte);
  if (settings.space != ColorSpace::kRgb)
    packed.rgb.assign(picture.color.pixels.begin(), picture.color.pixels.end());
  if (wants_spread(settings)) packed.spread = spread_of(packed);
  return packed;
}

void clear_hidden(PackedPicture& picture) {
  for (std::uint32_t& word : picture.words) word &= ~kHidden;
}

}  // namespace glassbox::views
