// Census words (Zabih and Woodfill 1994) as planes of bytes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "views/matching/byte_kernels.h"
#include "views/matching/pictures.h"

namespace glassbox::views {

// One bit for each of 32 neighbours, those of a window of 7 by 5 but for the two at the ends of its own row; beyond the edge the
// picture's last row and column go on. A row begins `pitch` bytes behind the one before it.
struct CensusPlanes {
  std::size_t pitch = 0;
  std::array<LineVector<std::uint8_t>, kCensusBytes> bytes;

  CensusPointers<const std::uint8_t> row(int y) const;
};

// Whether the neighbour is darker than the centre. Gain and offset of the grey do not change a word (C-110), but where they clip.
CensusPlanes darker_neighbours(const Planes& picture, Target target);

// Whether no channel is further off than kAlike: such a neighbour is likely to lie on the same surface, and to move with the centre.
// Where fewer than kLeastAlike are so, a texture is strong rather than a surface narrow, and all count.
inline constexpr std::uint8_t kAlike = 30;  // codes
inline constexpr std::uint8_t kLeastAlike = 12;
CensusPlanes alike_neighbours(const Planes& picture, Target target);

}  // namespace glassbox::views
