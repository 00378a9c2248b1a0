// One outline in the plane to triangles.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>

#include <glassbox/mesh/exact.h>

namespace glassbox {

// Cuts a counter-clockwise outline of n >= 3 points into n - 2 triangles, handed to `cut` as indices into `outline` in
// the order of the outline. Returns whether no triangle turns clockwise: false where the outline crosses itself or took
// more tests than the budget.
//
// Corners queue up from point 0 on. One that is an ear (turns left, and no other corner that does not turn left lies in
// its triangle) is cut off, and its two neighbours go to the end of the queue, which keeps triangles from becoming
// needles. An empty queue means that the outline touches or crosses itself; then, in this order, the first corner
// without area is cut (a spike, a repeated point), the first one whose triangle has no corner strictly inside, and
// otherwise the rest becomes a fan from its first point.
bool clip_ears(std::span<const FlatPoint> outline,
               const std::function<void(const std::array<std::uint32_t, 3>&)>& cut);

}  // namespace glassbox
