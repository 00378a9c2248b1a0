// The round trips of a run taken together: object space to the screen in float and back (pipeline/round_trip.h).
#pragma once

#include <cstdint>

#include <glassbox/render/trace/bounds.h>
#include <glassbox/render/trace/records.h>

namespace glassbox {

// Which coordinate of which corner of which triangle.
struct RoundTripPlace {
  std::uint32_t triangle = 0;  // number in the whole scene
  std::uint32_t corner = 0;    // 0, 1 or 2
  std::uint32_t axis = 0;
};

struct RoundTrips {
  std::uint64_t corners = 0;    // of triangles, that have a place on the screen
  std::uint64_t unbounded = 0;  // of these, how many nothing can be said of
  // Of the others, the coordinate that comes back furthest from where it was, in units of its object space ...
  double largest_error = 0;
  double bound = 0;
  RoundTripPlace place;
  // ... and how much of its bound any of them uses: never more than 1.
  double largest_ratio = 0;

  void see(const TracedTriangle& triangle, const TriangleBounds& bounds);
};

}  // namespace glassbox
