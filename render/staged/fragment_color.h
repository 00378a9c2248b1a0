// The colour of a fragment: the inputs of the formulas in raster/formulas/surface.h, and the bytes
// that are stored. It is in a header so that it is inlined into the loop over the pixels.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <glassbox/raster/blend.h>
#include <glassbox/raster/light_formulas.h>
#include <glassbox/raster/texture.h>
#include <glassbox/render/engine/observer.h>
#include <glassbox/render/staged/primitives.h>

namespace glassbox {

// ---- surfaces ----

// The data that a primitive provides for each of its fragments.
struct Surface {
  std::array<Varyings, 3> vertices;      // interpolated with Fragment::weights
  std::optional<TexturePlanes> texture;  // set if the base colour or the emission is textured
  FragmentSource source;
  std::uint32_t id = 0;  // the value for Framebuffer::id
  // With several samples per pixel: whether it also writes depth, distance and id, which the
  // framebuffer stores for pixel centres.
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

// Returns the level of the mip chain that suits the fragment; 0 for lines and points.
inline float detail_at(const MipChain& texture, const Surface& surface, const Varyings& at,
                       const Fragment& fragment) {
  if (!surface.texture) return 0.0f;
  return level_of_detail(texture_gradient(*surface.texture, at.texcoord, fragment.inverse_w),
                         texture.width, texture.height);
}

// A fragment of the staged reference, with the members that formulas/surface.h needs.
template <class Watch>
struct StagedFragment : UnobservedFragment {
  using Float = float;
  static constexpr std::size_t kChannels = 3;

  const FragmentStage& stage;
  const Watch& watch;
  const Surface& surface;
  const Varyings& at;
  const Fragment& fragment;

  static constexpr std::size_t first_channel() { return 0; }
  template <class T>
  static const std::array<T, 3>& wanted(const std::array<T, 3>& three) {
    return three;
  }
  SurfaceColorOf<float> look_up(const LazyMipChain& lazy, const Sampler& sampler) const {
    const MipChain& texture = lazy.get();
    const auto [r, g, b, a] =
        sample_mip_chain(texture, sampler, at.texcoord, detail_at(texture, surface, at, fragment));
    return {{r, g, b}, a};
  }

  const Material& material() const { return *stage.draw.material; }
  static constexpr bool has_vertex_color() { return true; }  // it is white if the mesh has none
  SurfaceColorOf<float> vertex_color() const {
    return {{at.color[0], at.color[1], at.color[2]}, at.color[3]};
  }
  bool has_texture() const { return stage.draw.texture != nullptr; }
  SurfaceColorOf<float> texel() const { return look_up(*stage.draw.texture, *stage.draw.sampler); }

  bool is_lit() const { return needs_normals(stage.draw, stage.settings); }
  const Lighting& lighting() const { return stage.lighting; }
  static constexpr bool has_highlights() { return true; }
  const std::array<float, 3>& normal() const { return at.normal; }
  const std::array<float, 3>& position() const { return at.position; }
  bool is_lit_at_vertices() const { return stage.settings.shading != Shading::kPhong; }
  Reflection light_of_vertices() const { return {at.diffuse, at.specular}; }

  bool emits() const { return stage.draw.emits() && shows_light(stage.draw, stage.settings); }
  const std::array<float, 3>& emission() const { return stage.draw.emission; }
  bool has_emission_texture() const { return stage.draw.emission_texture != nullptr; }
  std::array<float, 3> emission_texel() const {
    return look_up(*stage.draw.emission_texture, *stage.draw.emission_sampler).color;
  }
  void emitted(std::array<float, 3>& own) const { watch.notify(&Observer::emitted, at, own); }
};

// Whether the fragment's alpha is below the material's cutoff.
inline bool is_discarded(const Material& material, const Rgba& surface) {
  return material.alpha_mode == AlphaMode::kMask && !reaches_cutoff(surface.a, material);
}

// Whether the fragment is blended over the colour that is there. (Pictures of normals and texture
// coordinates are opaque.)
inline bool is_blended(const FragmentStage& stage) {
  return stage.draw.material->alpha_mode == AlphaMode::kBlend &&
         stage.settings.show != Show::kNormal && stage.settings.show != Show::kUv;
}

// ---- colours ----

// Returns a direction as a colour: each component is mapped from [-1, 1] to [0, 255].
inline Rgba8 picture_of_normal(const std::array<float, 3>& n) {
  const float squared = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
  const float scale = squared > 0.0f ? 0.5f / std::sqrt(squared) : 0.0f;
  return {encode_unorm8(n[0] * scale + 0.5f), encode_unorm8(n[1] * scale + 0.5f),
          encode_unorm8(n[2] * scale + 0.5f), 255};
}

// Returns texture coordinates modulo 1 as red and green.
inline Rgba8 picture_of_texcoord(const std::array<float, 2>& t) {
  return {encode_unorm8(t[0] - std::floor(t[0])), encode_unorm8(t[1] - std::floor(t[1])), 0, 255};
}

// The colour that a fragment writes: its light, or, as bytes, the quantity that is shown instead
// (the normal or the texture coordinates).
struct FragmentColor {
  Rgba light;
  std::optional<Rgba8> quantity;
};

template <class Watch>
FragmentColor fragment_color(const StagedFragment<Watch>& of, const Rgba& base) {
  const auto& [stage, watch, surface, at, fragment] = of;
  if (stage.settings.show == Show::kNormal) return {{}, picture_of_normal(at.normal)};
  if (stage.settings.show == Show::kUv) return {{}, picture_of_texcoord(at.texcoord)};
  const auto [r, g, b] = shaded_color(of, std::array<float, 3>{base.r, base.g, base.b});
  Rgba color{r, g, b, base.a};
  watch.notify(&Observer::lit, at, base, color);
  const bool blended = stage.draw.material->alpha_mode == AlphaMode::kBlend;
  // Alpha of a vertex colour may exceed 1.
  color.a = blended ? std::clamp(color.a, 0.0f, 1.0f) : 1.0f;
  return {color, {}};
}

// Returns the bytes to store in place of `before`.
inline Rgba8 encode_color(const FragmentStage& stage, const FragmentColor& color,
                          const Rgba8& before) {
  if (color.quantity) return *color.quantity;
  if (stage.draw.material->alpha_mode == AlphaMode::kBlend) {
    return blend_over(stage.settings.transfer, color.light, before, stage.channels);
  }
  return encode(stage.settings.transfer, color.light, stage.channels);
}

}  // namespace glassbox
