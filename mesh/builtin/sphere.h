// A ball of radius 1 in slices and stacks.
#pragma once

#include <glassbox/mesh/scene.h>

namespace glassbox {

inline constexpr int kSphereLevel = 32;
inline constexpr int kMaxSphereLevel = 1024;

// `level` stacks from pole to pole and 2 * level slices around, 2 .. 1024: quads, and triangles at
// the poles. The surface is closed; texture coordinates go around from -z over -x and down from the
// north pole.
Scene make_sphere(int level = kSphereLevel);

}  // namespace glassbox
