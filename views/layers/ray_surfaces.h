// What a scene looks like where a ray meets it, seen from a view: the fragments' colours at any point of a surface.
#pragma once

#include <vector>

#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/staged/vertex_stage.h>

#include "views/layers/ray_caster.h"

namespace glassbox::views {

// World units: a surface with a corner farther from the eye along an axis is left out, for floats end soon after.
inline constexpr double kFarthest = 1e30;

class RaySurfaces {
public:
  // Of a perspective view. Shading is unlit or kPhong's. The scene must outlive it.
  RaySurfaces(const Scene& scene, const View& view, const RenderSettings& settings);
  RaySurfaces(const RaySurfaces&) = delete;
  RaySurfaces& operator=(const RaySurfaces&) = delete;

  // In eye space.
  const RayCaster& caster() const { return caster_; }

  // Of its triangle, as Framebuffer::id has it.
  std::uint32_t number(const RayHit& hit) const;

  // Neither culled nor, by its mask, a hole.
  bool shows(const RayHit& hit) const;

  // As the engines draw it: light, highlights as the view's eye sees them, and of textures what suits the view's pixels there.
  Rgba8 color(const RayHit& hit) const;

private:
  struct Place {
    std::uint32_t draw, triangle;  // of the draw's triangulation
  };

  static std::vector<TriangleCorners> corners_of(const DrawList& list, std::vector<Place>& places);
  struct RayFragment;

  float detail_at(const MipChain& texture, const RayHit& hit, const Draw& draw,
                  const Triangle& triangle) const;
  Rgba texel_at(const LazyMipChain& texture, const Sampler& sampler, const RayHit& hit) const;
  std::array<float, 3> normal_at(const RayHit& hit) const;

  const View view_;
  const RenderSettings settings_;
  PreparedScene prepared_;
  DrawList list_;
  std::vector<EyeSpaceTables> tables_;  // by draw
  std::vector<Place> places_;           // by the caster's triangle
  RayCaster caster_;
};

}  // namespace glassbox::views
