// Rectangles whose depth is the difference of two numbers near 1/2: the computed depth differs by
// up to 2^-25 from the depth by their matrix. Whether a rectangle can be rejected or accepted by
// its bounding box alone therefore depends on the slack for rounding errors.
//
// No exact oracle knows the right picture, because each vertex is where rounding has put it. But
// the picture of a mesh must not depend on what else the mesh contains: another triangle, outside
// the picture, makes the bounding box too large for any decision, and every pixel must stay the
// same.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "study/extremes/common/tested_engine.h"

namespace glassbox::study {

// A rectangle that fills the picture of a parallel camera with the near plane at 1/2 and the far
// plane at 20. It is 2e5 wide and at `z` near 10^6 in its mesh. The mesh has no anchor, because its
// distance is at most eight times its size.
struct FarPane {
  float z = 0;
  double scale_z = 1;
  double behind_near = 0;  // how far its plane is moved back, before z is scaled and added
  std::array<float, 3> color{1, 1, 1};
};

struct PixelChanges {
  std::uint64_t changed = 0;  // pixels that differ between the two pictures
  std::uint64_t shown = 0;    // pixels that are not black, with the added triangle
};
// Draws each rectangle as a draw of its own, without and with the added triangle.
PixelChanges compare_with_added_triangle(const TestedEngine& engine,
                                         const std::vector<FarPane>& panes);

}  // namespace glassbox::study
