// Census words (Zabih and Woodfill 1994): a word has a bit for each neighbour of a pixel. The bytes
// of the words are stored in planes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "views/matching/byte_kernels.h"
#include "views/matching/color_planes.h"

namespace glassbox::views {

// One bit for each of 32 neighbours: those in a window of 7 by 5 pixels, except the centre and the
// first and last pixel of the centre's row. Beyond the edge, the picture's last row and column are
// repeated. Rows are `pitch` bytes apart.
struct CensusPlanes {
  std::size_t pitch = 0;
  std::array<CacheAlignedVector<std::uint8_t>, kCensusBytes> bytes;

  CensusPointers<const std::uint8_t> row(int y) const;
};

// Each bit says whether the neighbour is darker than the centre. A gain or an offset of the
// picture's grey changes no bit, except where values are clipped (C-110).
CensusPlanes darker_neighbours(const ColorPlanes& picture, Target target);

// Each bit says whether the neighbour is similar: all its channels differ from the centre's by at
// most kSimilarColor. A similar neighbour is likely to be on the same surface, and so to have the
// centre's disparity. If fewer than kMinSimilar neighbours are similar, the cause is more likely
// a strong texture than a narrow surface, and the bits of all neighbours are set.
inline constexpr std::uint8_t kSimilarColor = 30;  // sRGB codes (0 .. 255)
inline constexpr std::uint8_t kMinSimilar = 12;
CensusPlanes similar_neighbours(const ColorPlanes& picture, Target target);

}  // namespace glassbox::views
