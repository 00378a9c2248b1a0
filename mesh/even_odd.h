// The inside of one outline in the plane by the even-odd rule, where the outline may touch itself.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glassbox/mesh/exact.h>

namespace glassbox {

// How the edges of an outline meet, apart from neighbours at their common corner.
enum class Meeting {
  kNone,   // the outline is simple, or was too long to be examined
  kTouch,  // a corner is repeated or lies on an edge, or edges lie on each other
  kCross,  // edges cross where one of them has no corner
};

struct EvenOdd {
  Meeting meeting = Meeting::kNone;
  // Where the outline touches itself: the connected parts of its inside, each as a ring of indices
  // into the outline, counter-clockwise. A ring may come to one place several times, and go along
  // an edge in both directions (as to a hole and back), but its inside is one piece without a hole.
  // The triangles of all rings together are at most n - 2 for an outline of n corners. There is no
  // ring where the outline encloses nothing.
  std::vector<std::vector<std::uint32_t>> rings;
};

// Examines an outline. All decisions are exact. A place is inside if a ray from it to the outside
// passes the outline an odd number of times, so an edge that is passed twice is no border, and a
// spike encloses nothing.
//
// Takes O(n log n) for outlines that occur in practice. The work for one outline is limited to
// 2^27 + 2^10 n pairs of edges that are compared, where a corner on an edge counts as 2^9 pairs. An
// outline that needs more is not examined.
EvenOdd find_even_odd(std::span<const FlatPoint> outline);

}  // namespace glassbox
