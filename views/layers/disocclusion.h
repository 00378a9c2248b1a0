// Finds which surfaces the second eye would see that are hidden from the first one: a deeper layer
// has to contain these (S0-06, S1-09).
#pragma once

#include <cstdint>
#include <vector>

#include "views/layers/eye_kernels.h"

namespace glassbox::views {

struct DisocclusionBuffers {
  // For each pixel in a row of the second picture: the column of the first picture that it comes
  // from, computed from its depth; -1 for a hole.
  std::vector<float> from;
  // For each column, the first one from there on where a deeper surface may be visible.
  std::vector<int> next;
};

// Works on one row. Behind the surface that it hits, a line of sight of the first eye continues. In
// the second eye's picture this continuation runs to the right, from the surface to the line's
// point at infinite distance. `last` has the depth codes of the surfaces in a row of the first
// picture; `to` is the same row of the second picture, as far as it is known. For each pixel of the
// first picture, `behind` gets a depth code: the nearest surface behind this depth would become
// visible first, in a hole or in front of what the second picture's row shows; kEmptyDepth if there
// is no such depth. A surface whose parallax differs by less than a pixel from that of the surface
// that the line of sight hits is taken for the same surface. Returns whether any pixel has a code.
bool find_disocclusions(const EyeShift& shift, const std::uint32_t* last, int width,
                        const EyeTarget& to, DisocclusionBuffers& buffers, std::uint32_t* behind);

}  // namespace glassbox::views
