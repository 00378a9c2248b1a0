#include <glassbox/images/stereo/lenses.h>

#include <cstddef>

namespace glassbox {
namespace {

LightMatrix only(const EyeChannels& channels) {
  const bool let_through[3] = {channels.r, channels.g, channels.b};
  LightMatrix light = kScreenLight;
  for (auto& row : light) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (!let_through[i]) row[i] = 0;
    }
  }
  return light;
}

}  // namespace

Lenses lenses_of(Glasses glasses) {
  if (glasses == Glasses::kRedCyan) return {kRedLensLight, kCyanLensLight, true};
  const EyeMasks masks = eye_masks(glasses);
  return {only(masks.left), only(masks.right), false};
}

}  // namespace glassbox
