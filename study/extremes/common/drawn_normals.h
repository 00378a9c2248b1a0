// Compares the normals that complete runs show (Show::kNormal) with exact ones.
#pragma once

#include <array>
#include <vector>

#include <glassbox/mesh/scene.h>
#include <glassbox/render/engine/settings.h>

#include "study/extremes/common/outcome.h"
#include "study/extremes/common/polygons.h"
#include "study/extremes/common/tested_engine.h"

namespace glassbox::study {

// A mesh whose front faces +z. `place` moves it into the square -1 .. 1 in x and y, and into -1 ..
// 1 in z.
struct NormalTestMesh {
  Mesh mesh;
  Transform<World, Object> place;
  // The normal of all its fragments, of any length; zero if the face has none, which shows as the
  // middle value in all channels.
  std::array<double, 3> normal{};
};

NormalTestMesh make_normal_test_mesh(Mesh mesh, const Transform<World, Object>& place,
                                     const Vector<Object, exact::Rational>& normal);

// The bound for the direction of a shown face normal, in radians: a vector of double is rounded
// once; then there are rounding errors of the cofactors' entries, of three products and two sums of
// the same size, of the division by the length, and of the interpolation of three equal normals.
inline constexpr double kShownNormal = 14 * 0x1p-24;

// Draws the meshes side by side, seen along -z. Counts the pixels in which a channel differs
// from that of the normal by more than half a step of a byte plus what an angle of `radians` can
// change; infinite if a mesh is not visible.
Outcome measure_normal_error(const TestedEngine& engine, const std::vector<NormalTestMesh>& meshes,
                             Shading shading, double radians);

}  // namespace glassbox::study
