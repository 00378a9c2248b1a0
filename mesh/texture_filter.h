// Texture filters, by name, that replace the filters of all samplers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include <glassbox/mesh/scene.h>

namespace glassbox {

// The OpenGL filters that these stand for, in order: NEAREST; LINEAR; LINEAR, minified
// LINEAR_MIPMAP_NEAREST; LINEAR, minified LINEAR_MIPMAP_LINEAR.
enum class TextureFilter : std::uint8_t { kNearest, kBilinear, kBilinearLevels, kTrilinear };

constexpr std::string_view name_of(TextureFilter filter) {
  constexpr std::string_view kNames[] = {"nearest", "bilinear", "bilinear-levels", "trilinear"};
  return kNames[std::size_t(filter)];
}

// A sampler with the same wrapping and another filter.
constexpr Sampler with_filter(const Sampler& sampler, TextureFilter filter) {
  const Filter texels = filter == TextureFilter::kNearest ? Filter::kNearest : Filter::kLinear;
  const MipFilter levels = filter == TextureFilter::kTrilinear        ? MipFilter::kLinear
                           : filter == TextureFilter::kBilinearLevels ? MipFilter::kNearest
                                                                      : MipFilter::kNone;
  return {sampler.wrap_u, sampler.wrap_v, texels, texels, levels};
}

// The scene with this filter for all its textures.
inline Scene with_filter(Scene scene, TextureFilter filter) {
  for (Texture& texture : scene.textures) texture.sampler = with_filter(texture.sampler, filter);
  return scene;
}

}  // namespace glassbox
