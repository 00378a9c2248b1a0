// The colour of a fragment: texture, light, alpha, blend. It is in a header so that it is inlined
// into the loop over the pixels.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <glassbox/raster/blend.h>
#include <glassbox/raster/light_formulas.h>
#include <glassbox/raster/texture.h>
#include <glassbox/render/engine/observer.h>
#include <glassbox/render/staged/ready.h>

namespace glassbox {

// ---- the surface's own colour ----

// The data that a primitive provides for each of its fragments.
struct Surface {
  std::array<Varyings, 3> vertices;      // interpolated with Fragment::weights
  std::optional<TexturePlanes> texture;  // set if the base colour or the emission is textured
  FragmentSource source;
  std::uint32_t id = 0;  // the value for Framebuffer::id
  // With several samples per pixel it also writes to the planes of pixel centres.
  bool has_centres = false;
};

inline Surface surface_of(const FragmentStage& stage, const ReadyTriangle& triangle) {
  Surface surface;
  surface.vertices = triangle.vertices;
  surface.source = {triangle.number, triangle.piece, true};
  surface.id = triangle.number + 1;
  surface.has_centres = true;
  if (stage.draw.texture != nullptr || stage.draw.emission_texture != nullptr) {
    surface.texture = texture_planes(triangle.setup,
                                     {triangle.vertices[0].texcoord, triangle.vertices[1].texcoord,
                                      triangle.vertices[2].texcoord});
  }
  return surface;
}

// The level of the mip chain that suits the fragment; 0 for lines and points.
inline float detail_at(const MipChain& texture, const Surface& surface, const Varyings& at,
                       const Fragment& fragment) {
  if (!surface.texture) return 0.0f;
  return level_of_detail(texture_gradient(*surface.texture, at.texcoord, fragment.inverse_w),
                         texture.width, texture.height);
}

// Material times vertex colour times texture.
inline Rgba surface_color(const FragmentStage& stage, const Surface& surface, const Varyings& at,
                          const Fragment& fragment) {
  const Rgba& base = stage.draw.material->base_color;
  Rgba color{base.r * at.color[0], base.g * at.color[1], base.b * at.color[2],
             base.a * at.color[3]};
  if (stage.draw.texture != nullptr) {
    const MipChain& texture = stage.draw.texture->get();
    const Rgba texel = sample(texture, *stage.draw.sampler, at.texcoord,
                              detail_at(texture, surface, at, fragment));
    color = {color.r * texel.r, color.g * texel.g, color.b * texel.b, color.a * texel.a};
  }
  return color;
}

// Whether the fragment's alpha is below the material's cutoff.
inline bool is_discarded(const Material& material, const Rgba& surface) {
  return material.alpha_mode == AlphaMode::kMask && !(surface.a >= material.alpha_cutoff);
}

// Whether the fragment is blended over what is there. (Pictures of normals and texture coordinates
// are opaque.)
inline bool is_blended(const FragmentStage& stage) {
  return stage.draw.material->alpha_mode == AlphaMode::kBlend &&
         stage.settings.show != Show::kNormal && stage.settings.show != Show::kUv;
}

// ---- light ----

inline Rgba lit(const FragmentStage& stage, const Rgba& base, const Varyings& at) {
  if (!needs_normals(stage.draw, stage.settings)) return base;
  const Material& material = *stage.draw.material;
  const Reflection light =
      stage.settings.shading == Shading::kPhong
          ? illuminate(stage.lighting, at.position, at.normal, material.shininess)
          : Reflection{at.diffuse, at.specular};
  constexpr bool kHighlights = true;
  const auto [r, g, b] =
      lit<float>({base.r, base.g, base.b}, at.normal, light, material.specular, kHighlights);
  return {r, g, b, base.a};
}

// The light that the surface emits: its emission times the emission texture.
inline std::array<float, 3> emission_at(const FragmentStage& stage, const Surface& surface,
                                        const Varyings& at, const Fragment& fragment) {
  const std::array<float, 3>& emission = stage.draw.emission;
  if (stage.draw.emission_texture == nullptr) return emission;
  const MipChain& texture = stage.draw.emission_texture->get();
  const Rgba texel = sample(texture, *stage.draw.emission_sampler, at.texcoord,
                            detail_at(texture, surface, at, fragment));
  return {emission[0] * texel.r, emission[1] * texel.g, emission[2] * texel.b};
}

// The surface's colour after lighting, with its emission added.
template <class Watch>
Rgba shining(const FragmentStage& stage, const Watch& watch, const Surface& surface,
             const Varyings& at, const Fragment& fragment, const Rgba& base) {
  Rgba color = lit(stage, base, at);
  if (!stage.draw.emits() || !shows_light(stage.draw, stage.settings)) return color;
  std::array<float, 3> own = emission_at(stage, surface, at, fragment);
  watch.emitted(at, own);
  color.r += own[0], color.g += own[1], color.b += own[2];
  return color;
}

// A direction as a colour: each component is mapped from [-1, 1] to [0, 255].
inline Rgba8 picture_of_normal(const std::array<float, 3>& n) {
  const float squared = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
  const float scale = squared > 0.0f ? 0.5f / std::sqrt(squared) : 0.0f;
  return {encode_unorm8(n[0] * scale + 0.5f), encode_unorm8(n[1] * scale + 0.5f),
          encode_unorm8(n[2] * scale + 0.5f), 255};
}

// Texture coordinates modulo 1 as red and green.
inline Rgba8 picture_of_texcoord(const std::array<float, 2>& t) {
  return {encode_unorm8(t[0] - std::floor(t[0])), encode_unorm8(t[1] - std::floor(t[1])), 0, 255};
}

// The colour that a fragment writes: its light, or, as bytes, the quantity that is shown instead.
struct FragmentColor {
  Rgba light;
  std::optional<Rgba8> quantity;
};

template <class Watch>
FragmentColor fragment_color(const FragmentStage& stage, const Watch& watch, const Surface& surface,
                             const Varyings& at, const Fragment& fragment, const Rgba& base) {
  if (stage.settings.show == Show::kNormal) return {{}, picture_of_normal(at.normal)};
  if (stage.settings.show == Show::kUv) return {{}, picture_of_texcoord(at.texcoord)};
  Rgba color = shining(stage, watch, surface, at, fragment, base);
  watch.lit(at, base, color);
  const bool blended = stage.draw.material->alpha_mode == AlphaMode::kBlend;
  color.a = blended ? std::clamp(color.a, 0.0f, 1.0f) : 1.0f;  // vertex colours may exceed 1
  return {color, {}};
}

// Returns the bytes to store where `before` was stored.
inline Rgba8 encoded(const FragmentStage& stage, const FragmentColor& color, const Rgba8& before) {
  if (color.quantity) return *color.quantity;
  if (stage.draw.material->alpha_mode == AlphaMode::kBlend) {
    return blend_over(stage.settings.transfer, color.light, before, stage.channels);
  }
  return encode(stage.settings.transfer, color.light, stage.channels);
}

}  // namespace glassbox
