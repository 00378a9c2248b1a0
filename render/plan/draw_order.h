// Front to back, where that changes no byte.
#pragma once

#include <cstdint>
#include <span>

#include <glassbox/render/plan/box_bounds.h>

namespace glassbox {

// Of two opaque draws whose codes have none in common the nearer one wins every pixel of both, whichever is drawn first. (With a
// code in common the first would win, so those keep their order.)
inline bool may_overtake(const DepthCodes& later, const DepthCodes& earlier) {
  return later.farthest < earlier.nearest;
}

// Moves draws of `order`, indices into `codes`, towards the front past those that they may overtake; returns how many have
// moved there. One overtakes at most kMostOvertaken others, so that thousands of draws are ordered in less time than that saves.
inline constexpr std::size_t kMostOvertaken = 256;
std::size_t order_front_to_back(std::span<std::uint32_t> order, std::span<const DepthCodes> codes);

}  // namespace glassbox
