// The colour of a fragment: texture, light, alpha, blend.
#pragma once

#include <array>
#include <optional>

#include <glassbox/raster/texture.h>
#include <glassbox/render/fragments.h>

namespace glassbox {

// What a primitive brings for each of its fragments.
struct Surface {
  std::array<Varyings, 3> vertices;      // interpolated with Fragment::weights
  std::optional<TexturePlanes> texture;  // of textured triangles
};

Surface surface_of(const FragmentStage& stage, const ReadyTriangle& triangle);

// The surface's own colour at a fragment: material times vertex colour times texture.
Rgba surface_color(const FragmentStage& stage, const Surface& surface, const Varyings& at,
                   const Fragment& fragment);

// Its alpha lies below the material's cutoff.
bool is_discarded(const Material& material, const Rgba& surface);

// It is laid over what is there. (Pictures of normals and texture coordinates are opaque.)
bool is_blended(const FragmentStage& stage);

// What a fragment brings to wherever it is written: its light, or the quantity asked for in its place, as bytes.
struct FragmentColor {
  Rgba light;
  std::optional<Rgba8> quantity;
};
FragmentColor fragment_color(const FragmentStage& stage, const Varyings& at, const Rgba& surface);

// What is stored over `before`.
Rgba8 encoded(const FragmentStage& stage, const FragmentColor& color, const Rgba8& before);

}  // namespace glassbox
