// The appearance of a scene's surfaces where a ray hits them, seen from a view: the colour of a
// fragment at any point of a surface.
#pragma once

#include <vector>

#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/staged/vertex_stage.h>

#include "views/layers/ray_caster.h"

namespace glassbox::views {

// World units: surfaces with a corner farther from the eye than this along an axis are left out,
// because the range of float ends soon after.
inline constexpr double kFarthest = 1e30;

class RaySurfaces {
public:
  // The view must be perspective, and the shading unlit or kPhong. The scene must outlive this
  // object.
  RaySurfaces(const Scene& scene, const View& view, const RenderSettings& settings);
  RaySurfaces(const RaySurfaces&) = delete;
  RaySurfaces& operator=(const RaySurfaces&) = delete;

  // The caster's triangles are in eye space.
  const RayCaster& caster() const { return caster_; }

  // The number of the hit triangle, as in Framebuffer::id.
  std::uint32_t number(const RayHit& hit) const;

  // Whether the surface is drawn at the hit: it is not culled, and its alpha mask has no hole
  // there.
  bool is_drawn_at(const RayHit& hit) const;

  // The colour that the engines draw: light, highlights as the view's eye sees them, and textures
  // at the level that suits the view's pixels there.
  Rgba8 color(const RayHit& hit) const;

private:
  struct TriangleReference {
    std::uint32_t draw, triangle;  // in the draw's triangulation
  };

  static std::vector<TriangleCorners> corners_of(const DrawList& list,
                                                 std::vector<TriangleReference>& references);
  struct RayFragment;

  float detail_at(const MipChain& texture, const RayHit& hit, const Draw& draw,
                  const Triangle& triangle) const;
  Rgba texel_at(const LazyMipChain& texture, const Sampler& sampler, const RayHit& hit) const;
  std::array<float, 3> normal_at(const RayHit& hit) const;

  const View view_;
  const RenderSettings settings_;
  PreparedScene prepared_;
  DrawList list_;
  std::vector<EyeSpaceTables> tables_;                  // one for each draw
  std::vector<TriangleReference> triangle_references_;  // one for each triangle of caster_
  RayCaster caster_;
};

}  // namespace glassbox::views
