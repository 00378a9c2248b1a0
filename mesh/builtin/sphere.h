// A ball of radius 1 in slices and stacks.
#pragma once

#include <glassbox/mesh/scene.h>

namespace glassbox {

inline constexpr int kSphereLevel = 32;
inline constexpr int kMaxSphereLevel = 1024;

// Makes a ball of `level` stacks from pole to pole and 2 * level slices around, with `level` from 2
// to 1024. The faces are quads, and triangles at the poles; the surface is closed. The texture
// coordinate u grows around the ball from -z over -x, v grows from the north pole down.
Scene make_sphere(int level = kSphereLevel);

}  // namespace glassbox
