// Which surfaces behind what one eye sees the other eye would see: what a deeper layer has to have (S0-06, S1-09).
#pragma once

#include <cstdint>
#include <vector>

#include "views/layers/eye_kernels.h"

namespace glassbox::views {

struct BehindMemory {
  std::vector<float>
      from;  // the column of the one eye's picture that the other's pixel shows, by its depth
  std::vector<int> next;  // from a column on, the next one whose pixel may show more
};

// A line of sight of the first eye goes on behind what it has met, and in the second eye's picture it runs to the right, from the one's place to where
// infinity is. `last`: depth codes of what was met, row by row of the first picture; `to`: the second one's row as far as it is known. For each
// pixel the code behind which a surface would be seen first: in a hole, or in front of what the row has; kEmptyDepth: nowhere. What moves by less than
// a pixel more than what was met is not asked for: it is that surface's own. Whether any pixel has a code.
bool find_seen_behind(const EyeShift& shift, const std::uint32_t* last, int width,
                      const EyeTarget& to, BehindMemory& memory, std::uint32_t* behind);

}  // namespace glassbox::views
