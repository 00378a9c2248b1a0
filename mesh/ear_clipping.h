// Cuts one outline in the plane into triangles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include <glassbox/mesh/exact.h>

namespace glassbox {

struct EarClipping {
  bool proper = true;  // no triangle turns clockwise
  // The work: the number of tested corners, and of tested cells of the grid that finds the corners.
  std::int64_t test_count = 0;
};

// Cuts a counter-clockwise outline of n >= 3 points into n - 2 triangles, which are passed to `cut`
// as indices into `outline` in the order of the outline. An outline that touches itself is correct
// only as rings of find_even_odd(). `proper` can be false only if the outline touches itself in
// another way or crosses itself, or if the work was more than ear_budget(n).
//
// Corners are queued, starting with point 0. A corner is an ear if it turns left and no other
// corner that does not turn left is in its triangle. An ear is cut off, and its two neighbours go
// to the end of the queue, which prevents long thin triangles. An empty queue means that the
// outline touches or crosses itself. Then the first corner without area (a spike, a repeated point)
// is cut; if there is none, the first corner whose triangle has no other corner strictly inside; if
// there is none, the rest becomes a fan from its first point.
EarClipping clip_ears(std::span<const FlatPoint> outline,
                      const std::function<void(const std::array<std::uint32_t, 3>&)>& cut);

// The maximum work for an outline of n points, after which the rest of it is cut as a fan.
constexpr std::int64_t ear_budget(std::size_t n) {
  return (std::int64_t(1) << 27) + (std::int64_t(n) << 10);
}

}  // namespace glassbox
