// Normals that whole runs show (Show::kNormal), against exact ones.
#pragma once

#include <array>
#include <vector>

#include <glassbox/mesh/scene.h>
#include <glassbox/render/engine/settings.h>

#include "study/extremes/kit/drawer.h"
#include "study/extremes/kit/outcome.h"
#include "study/extremes/kit/polygons.h"

namespace glassbox::study {

// A mesh whose front is seen from +z once it has been carried to the square -1 .. 1 of x and y, and to -1 .. 1 of z.
struct Specimen {
  Mesh mesh;
  Transform<World, Object> place;
  // Of all its fragments, of any length; zero: the face has none, which shows in the middle of all channels.
  std::array<double, 3> normal{};
};

Specimen specimen(Mesh mesh, const Transform<World, Object>& place,
                  const Vector<Object, exact::Rational>& normal);

// How far the direction of a face's normal may be off: one rounding of a vector of double, the entries of the cofactors, three products
// and two sums of one size, the unit length, and three equal ones interpolated.
inline constexpr double kShownNormal = 14 * 0x1p-24;

// Specimens beside each other, looked at along -z. Pixels in which a channel is farther from its normal's than half a byte and an
// angle of `radians`; infinite where a specimen is not seen.
Outcome judge_normals(const Drawer& by, const std::vector<Specimen>& specimens, Shading shading,
                      double radians);

}  // namespace glassbox::study
