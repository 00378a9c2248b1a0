// Rectangles whose depth is the difference of two numbers near 1/2: rounding changes the computed
// depth by up to 2^-25. Whether a rectangle can be rejected or accepted by its bounding box alone
// therefore depends on the margin for rounding errors.
//
// The right picture cannot be computed exactly, because each vertex is where rounding has put it.
// But the picture of a mesh must not depend on what else the mesh contains: another triangle,
// outside the picture, makes the bounding box too large for any decision, and every pixel must stay
// the same.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "study/extremes/common/tested_engine.h"

namespace glassbox::study {

// A rectangle that fills the picture of a parallel camera with the near plane at 1/2 and the far
// plane at 20. In its mesh it is 2e5 wide and at `z`, near 10^6. The mesh has no anchor, because
// its distance from the origin is at most eight times its size.
struct FarPane {
  float z = 0;
  double scale_z = 1;
  double behind_near = 0;  // how far it would be behind the near plane if z * scale_z were 10
  std::array<float, 3> color{1, 1, 1};
};

struct PixelChanges {
  // Pixels that differ between the pictures with and without the added triangle.
  std::uint64_t changed = 0;
  std::uint64_t shown = 0;  // pixels that are not black in the picture with the added triangle
};
// Draws each rectangle as a draw of its own, without and with the added triangle.
PixelChanges compare_with_added_triangle(const TestedEngine& engine,
                                         const std::vector<FarPane>& panes);

}  // namespace glassbox::study
