// Newell's teapot.
#pragma once

#include <glassbox/mesh/scene.h>

namespace glassbox {

inline constexpr int kTeapotLevel = 16;
inline constexpr int kMaxTeapotLevel = 256;

// Makes the 32 patches of the teapot. Each has `level` x `level` cells of two triangles (one
// triangle where a side of the cell is a single point), with `level` in 1 .. 256. y is up, the
// teapot stands on y = 0, with its spout towards +x.
//
// Neighbouring patches compute the same floats for their common border and share its positions, so
// that there are no gaps. The model itself has 16 border curves that belong to one patch only: the
// inside of the rim (4), the edge of the lid (4), the ends of the handle (2 each) and of the spout
// (2 each). The lower end of the handle touches the body in one vertex. At level 1 the handle and
// the spout are flat, and four of their triangles have no area.
Scene make_teapot(int level = kTeapotLevel);

// Makes the mesh alone, with unit normals from the derivatives of the surface and the (u, v) of
// each patch as texture coordinates.
Mesh tessellate_teapot(int level);

}  // namespace glassbox
