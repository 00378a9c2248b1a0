// Makes one texture for all points of view: each triangle has a patch of it. Every texel of a patch
// has the colour that the views show there, blended for an eye straight in front of the triangle.
#pragma once

#include "views/texture/textured_surface.h"

namespace glassbox::views {

inline constexpr int kMinTexels = 4, kMaxTexels = 64;

// Bytes needed for the texture and for writing it to a file.
double static_texture_bytes(std::size_t triangles, int texels);

// A copy of the scene, unlit, whose triangles have texture coordinates. `texels` is the side of a
// square of the texture that two triangles share. An error for a texture of more than 16384 texels
// to a side, or one that needs more than `most_bytes`.
Result<Scene> with_static_texture(const Scene& scene, const TexturedSurface& surface, int texels,
                                  double most_bytes);

}  // namespace glassbox::views
