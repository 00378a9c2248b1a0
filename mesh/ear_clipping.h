// One outline in the plane to triangles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include <glassbox/mesh/exact.h>

namespace glassbox {

struct EarClipping {
  bool proper = true;          // no triangle turns clockwise
  std::int64_t looked_at = 0;  // corners, and cells of the grid that finds them: the work
};

// Cuts a counter-clockwise outline of n >= 3 points into n - 2 triangles, handed to `cut` as indices into `outline` in
// the order of the outline. Improper where the outline crosses itself, or where more was looked at than ear_budget(n).
//
// Corners queue up from point 0 on. One that is an ear (turns left, and no other corner that does not turn left lies in
// its triangle) is cut off, and its two neighbours go to the end of the queue, which keeps triangles from becoming
// needles. An empty queue means that the outline touches or crosses itself; then, in this order, the first corner
// without area is cut (a spike, a repeated point), the first one whose triangle has no corner strictly inside, and
// otherwise the rest becomes a fan from its first point.
EarClipping clip_ears(std::span<const FlatPoint> outline,
                      const std::function<void(const std::array<std::uint32_t, 3>&)>& cut);

// What an outline of n points may cost before the rest of it is cut as a fan.
constexpr std::int64_t ear_budget(std::size_t n) {
  return (std::int64_t(1) << 27) + (std::int64_t(n) << 10);
}

}  // namespace glassbox
