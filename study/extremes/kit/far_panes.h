// Panes whose depth is the difference of two numbers near 1/2, so that it is computed up to 2^-25 from where their matrix puts it: what
// may be said of their box without looking at a vertex hangs on its slack for rounding.
//
// What is right there no exact oracle knows, for each vertex is where its rounding has put it. But what a picture shows of a mesh does
// not depend on what else the mesh has: with a triangle more, beside the picture, that makes its box too large for anything to be said
// of it, every pixel must be what it is without.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "study/extremes/kit/drawer.h"

namespace glassbox::study {

// Fills the picture of a parallel camera with the near plane at 1/2 and the far plane at 20. 2e5 wide, at `z` near 10^6 in its mesh, which
// has no anchor, for it is not farther than eight times its size.
struct FarPane {
  float z = 0;
  double scale_z = 1;
  double behind_near = 0;  // how far its plane is moved, before z is scaled and added
  std::array<float, 3> color{1, 1, 1};
};

struct Company {
  std::uint64_t changed = 0;  // pixels
  std::uint64_t shown = 0;    // pixels that are not black in company
};
// Each pane a draw of its own, alone and in company.
Company changed_by_company(const Drawer& by, const std::vector<FarPane>& panes);

}  // namespace glassbox::study
