// Orders draws front to back, where that changes no byte.
#pragma once

#include <cstdint>
#include <span>

#include <glassbox/render/plan/box_bounds.h>

namespace glassbox {

// Whether the later of two opaque draws may be drawn before the earlier one because it is nearer:
// all its depth codes are smaller, so it wins every pixel that both cover, in either order. (If
// both had fragments with the same code, the one that is drawn first would win, so draws whose
// ranges of codes overlap keep their order.)
inline bool may_overtake(const DepthCodes& later, const DepthCodes& earlier) {
  return later.farthest < earlier.nearest;
}

// Moves each draw of `order` (indices into `codes`) towards the front, past the draws that it may
// overtake. Returns how many draws have moved. A draw overtakes at most kMaxOvertaken others, so
// that ordering thousands of draws takes less time than it saves.
inline constexpr std::size_t kMaxOvertaken = 256;
std::size_t order_front_to_back(std::span<std::uint32_t> order, std::span<const DepthCodes> codes);

}  // namespace glassbox
