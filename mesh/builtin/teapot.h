// Newell's teapot.
#pragma once

#include <glassbox/mesh/scene.h>

namespace glassbox {

inline constexpr int kTeapotLevel = 16;
inline constexpr int kMaxTeapotLevel = 256;

// Makes the 32 patches, each as `level` x `level` cells of two triangles (one where a side is a
// single point), level 1 .. 256. y is up, the teapot stands on y = 0, with its spout towards +x.
//
// Neighbouring patches evaluate their common border to the same floats and share its positions, so
// that there are no gaps. 16 border curves of the model itself are open: the inside of the rim (4),
// the edge of the lid (4), the ends of the handle (2 each) and of the spout (2 each). The lower end
// of the handle touches the body in one vertex. At level 1 handle and spout are flat, and four of
// their triangles have no area.
Scene make_teapot(int level = kTeapotLevel);

// The mesh alone, with unit normals from the surface's derivatives and (u, v) of the patch as
// texture coordinates.
Mesh tessellate_teapot(int level);

}  // namespace glassbox
