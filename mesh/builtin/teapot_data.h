// The teapot that Martin Newell modelled in Utah in 1975, as 32 bicubic Bezier patches: the numbers
// only.
#pragma once

#include <array>
#include <cstdint>

namespace glassbox {

// The control points, each stored once; x is towards the spout, z is up, the pot's axis is x = y =
// 0 and its bottom z = 0. The published copies differ in one point: Debian's POV-Ray example has
// (2, 1.2, 0.45), which breaks the mirror symmetry of all other points; the value here is the
// mirror image of (2, -1.12, 0.45).
extern const std::array<std::array<double, 3>, 290> kTeapotPoints;

// The indices of a patch's sixteen control points, row by row: u grows along a row, v from row to
// row, and dS/du x dS/dv of the surface S(u, v) points outwards. The patches of the rim are 0 - 3,
// the body 4 - 11, handle 12 - 15, spout 16 - 19, lid 20 - 27, bottom 28 - 31. The first rows of
// patches 20 - 23 (the lid's knob) and 28 - 31 (the bottom) are a single point each.
using TeapotPatch = std::array<std::uint16_t, 16>;
extern const std::array<TeapotPatch, 32> kTeapotPatches;

}  // namespace glassbox
