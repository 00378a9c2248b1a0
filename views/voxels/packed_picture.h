// A picture in the layout for the sweep: one word for each pixel, with its colour and two flags.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "views/rings/picture_set.h"
#include "views/voxels/settings.h"
#include "views/voxels/statistics.h"

namespace glassbox::views {

// Bit 31: a coloured voxel in front hides this pixel; bit 30: background. Below are three channels
// of ten bits each, in quarters of a level: R, G, B; or, for CIELab, L times its weight, a + 128, b
// + 128.
inline constexpr std::uint32_t kHidden = 0x80000000u, kBackground = 0x40000000u;
inline constexpr int kCodesPerLevel = 4, kChannelBits = 10;
inline constexpr std::uint32_t kChannelMask = 1023;

inline std::array<std::uint32_t, 3> channels_of(std::uint32_t word) {
  return {word & kChannelMask, word >> kChannelBits & kChannelMask,
          word >> (2 * kChannelBits) & kChannelMask};
}
inline void add_word(ColorSums& sums, std::uint32_t word) {
  const auto [a, b, c] = channels_of(word);
  sums.add(a, b, c);
}

using ProjectionMatrix = Eigen::Matrix<double, 3, 4>;

struct PackedPicture {
  ProjectionMatrix pixel_from_world;
  Vector3d eye = Vector3d::Zero();
  int width = 0, height = 0;
  // The matte has no object at its border: the object is entirely inside the picture, and
  // everything outside of the picture is background.
  bool shows_whole_object = false;
  std::vector<std::uint32_t> words;
  // If the settings need it: the deviation of the object's colours in the 3 x 3 pixels around each
  // pixel, in quarters of a level like the colours in `words`.
  std::vector<std::uint32_t> spread;
  // If the words are not RGB: the pixels' RGB, whose mean is the colour of a voxel.
  std::vector<Rgba8> rgb;
};

ProjectionMatrix projection_of(const PinholeCamera& camera);

// The three channels of a colour; bits 30 and 31 are 0.
std::uint32_t packed_color(const Rgba8& color, const ColoringSettings& settings);

PackedPicture pack_picture(const CalibratedPicture& picture, const ColoringSettings& settings);

inline bool wants_spread(const ColoringSettings& settings) {
  return settings.consistency == Consistency::kAdaptive || settings.edge > 0;
}

// Clears the hidden bit of every pixel.
void clear_hidden(PackedPicture& picture);

}  // namespace glassbox::views
