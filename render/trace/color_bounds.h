// Running error bounds of the colours of fragments: attributes, texture samples, light (bound 5 of
// SPEC C in docs/references.md, continued to the colour). They are computed by the stages' own
// formulas, with numbers that contain a bound of their own error (base/bounded.h).
//
// In addition to the inputs of bounds.h, these are taken as exact: normals, colours and texture
// coordinates as modelled, materials, the bytes of images, and the lights in eye space as computed
// by the run.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <glassbox/raster/bounded_formulas.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/trace/bounds.h>
#include <glassbox/render/trace/corner_bounds.h>

namespace glassbox {

// The run's numbers with their bounds.
struct ColorBounds {
  BoundedVaryings at;
  // The bound of a texture sample, in linear light; none where the surface has no texture.
  std::optional<double> sample;
  std::array<bounded::Bounded, 4> surface;  // the surface's own colour, linear, with alpha
  std::array<bounded::Bounded, 3> light;    // the colour after lighting, linear
};

// The bounds of the colours of a triangle of a fan, or of a line or point.
class PieceColors {
public:
  // The arguments `draw`, `lighting`, `settings` and `known` must outlive the object.
  PieceColors(const Draw& draw, const DrawBounds& draw_bounds, const Lighting& lighting,
              const RenderSettings& settings, const BoundsOfRun::KnownTriangle& known,
              std::uint32_t piece);

  // For a line or point, which is treated as a triangle whose vertex 0 has weight 0
  // (raster/interpolate.h), without slopes, at level 0 of its textures.
  PieceColors(const Draw& draw, const Lighting& lighting, const RenderSettings& settings,
              const TriangleSetup& setup, const SetupBounds& setup_bounds,
              const std::array<BoundedVaryings, 3>& vertices);

  // Returns the bounds for a fragment of the triangle that passed the depth test.
  ColorBounds at(const TracedFragment& fragment, const FragmentBounds& bounds) const;

private:
  struct BoundedFragment;

  std::array<bounded::Bounded, 4> sample(const MipChain& texture, const Sampler& sampler,
                                         const TracedFragment& fragment, const BoundedVaryings& at,
                                         const bounded::Bounded& inverse_w) const;
  void make_planes();

  const Draw& draw_;
  const Lighting& lighting_;
  const RenderSettings& settings_;
  TriangleSetup setup_;
  SetupBounds setup_bounds_;
  std::array<BoundedVaryings, 3> vertices_;  // attributes of the vertices, in the order of setup_
  bool has_slopes_ = false;
  TexturePlanes planes_;
  TexturePlanesOf<bounded::Bounded> bounded_planes_;
};

}  // namespace glassbox
