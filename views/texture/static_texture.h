// One texture for all eyes: each triangle has a patch of it, in which every texel has what the views show of it, blended for an eye
// straight before the triangle.
#pragma once

#include "views/texture/textured_surface.h"

namespace glassbox::views {

inline constexpr int kLeastTexels = 4, kMostTexels = 64;

// What it takes, and writing it.
double static_texture_bytes(std::size_t triangles, int texels);

// A copy of the scene, unlit, whose triangles have texture coordinates. `texels`: the side of a square that two triangles share. Refused:
// textures of more than 16384 texels to a side, and what takes more than `most_bytes`.
Result<Scene> with_static_texture(const Scene& scene, const TexturedSurface& surface, int texels,
                                  double most_bytes);

}  // namespace glassbox::views
