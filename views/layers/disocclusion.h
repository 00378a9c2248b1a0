// Which surfaces, hidden from the first eye, the second eye would see: what a deeper layer has to
// contain (S0-06, S1-09).
#pragma once

#include <cstdint>
#include <vector>

#include "views/layers/eye_kernels.h"

namespace glassbox::views {

struct DisocclusionBuffers {
  // For a pixel of the second picture, the column of the first one that it comes from, by its
  // depth.
  std::vector<float> from;
  std::vector<int> next;  // for a column, the next one whose pixel may show more
};

// Behind the surface that it hits, a line of sight of the first eye continues. In the second eye's
// picture it runs to the right, from the surface's place to the place of infinity. `last` has the
// depth codes of the surfaces, row by row of the first picture; `to` is the second picture's row as
// far as it is known. For each pixel of the first picture `behind` gets the code behind which a
// surface would become visible first, in a hole or in front of what the row shows; kEmptyDepth if
// nowhere. A surface whose parallax differs by less than a pixel from that of the hit one is taken
// for the same surface. Returns whether any pixel has a code.
bool find_disocclusions(const EyeShift& shift, const std::uint32_t* last, int width,
                        const EyeTarget& to, DisocclusionBuffers& buffers, std::uint32_t* behind);

}  // namespace glassbox::views
