// Census words (Zabih and Woodfill 1994) as planes of bytes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "views/matching/byte_kernels.h"
#include "views/matching/color_planes.h"

namespace glassbox::views {

// One bit for each of 32 neighbours: a window of 7 by 5 without the centre and without the two ends
// of its own row. Beyond the edge, the picture's last row and column are repeated. Rows are `pitch`
// bytes apart.
struct CensusPlanes {
  std::size_t pitch = 0;
  std::array<CacheAlignedVector<std::uint8_t>, kCensusBytes> bytes;

  CensusPointers<const std::uint8_t> row(int y) const;
};

// Whether each neighbour is darker than the centre. A gain or an offset of the grey does not change
// a word, except where values are clipped (C-110).
CensusPlanes darker_neighbours(const ColorPlanes& picture, Target target);

// Whether each neighbour's channels all differ from the centre's by at most kSimilarColor: such a
// neighbour is likely to be on the same surface, and to move with the centre. If fewer than
// kLeastSimilar neighbours do, the cause is more likely a strong texture than a narrow surface, and
// all of them count.
inline constexpr std::uint8_t kSimilarColor = 30;  // codes
inline constexpr std::uint8_t kLeastSimilar = 12;
CensusPlanes similar_neighbours(const ColorPlanes& picture, Target target);

}  // namespace glassbox::views
