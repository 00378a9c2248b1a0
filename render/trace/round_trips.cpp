#include <glassbox/render/trace/round_trips.h>

#include <algorithm>

namespace glassbox {

void RoundTrips::see(const TracedTriangle& triangle, const TriangleBounds& bounds) {
  for (std::uint32_t k = 0; k < 3; ++k) {
    const std::optional<RoundTrip>& trip = bounds.corners[k].round_trip;
    if (!trip) continue;
    ++corners;
    if (!trip->is_bounded()) {
      ++unbounded;
      continue;
    }
    for (int axis = 0; axis < 3; ++axis) {
      const double error = trip->error[axis];
      largest_ratio = std::max(largest_ratio, error / trip->bound[axis]);
      if (error < largest_error || (error == largest_error && bound > 0)) continue;
      largest_error = error;
      bound = trip->bound[axis];
      place = {triangle.number, k, std::uint32_t(axis)};
    }
  }
}

}  // namespace glassbox
