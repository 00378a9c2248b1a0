// A table for compacting eight lanes by a mask: the bytes of entry m are the positions of the bits
// set in m, the first one in the lowest byte.
#pragma once

#include <array>
#include <cstdint>

namespace glassbox {

inline constexpr std::array<std::uint64_t, 256> kCompactedLanes = [] {
  std::array<std::uint64_t, 256> lanes{};
  for (unsigned mask = 0; mask < 256; ++mask) {
    unsigned kept = 0;
    for (unsigned lane = 0; lane < 8; ++lane) {
      if ((mask >> lane & 1u) != 0) lanes[mask] |= std::uint64_t{lane} << 8 * kept++;
    }
  }
  return lanes;
}();

}  // namespace glassbox
