// Draws a single convex polygon of clip space: the stages from the divide to coverage, one after
// the other.
#pragma once

#include <span>
#include <vector>

#include <glassbox/pipeline/divide.h>
#include <glassbox/pipeline/viewport.h>
#include <glassbox/raster/coverage.h>
#include <glassbox/raster/fan.h>
#include <glassbox/raster/snap.h>

namespace glassbox {

// Calls visit(Coverage) for every pixel within `window` that the polygon covers. Vertices must be
// within the guard band.
template <class Visit>
void for_each_covered(std::span<const Point<Clip>> outline, const Viewport& viewport,
                      const PixelRect& window, Visit&& visit) {
  std::vector<ScreenVertex> screen;
  std::vector<SnappedVertex> snapped;
  for (const Point<Clip>& p : outline) {
    screen.push_back(to_screen(divide(p), viewport));
    snapped.push_back(snap(screen.back()));
  }
  const int count = int(outline.size());
  const int apex = fan_apex(snapped);
  for (int i = 0; i + 2 < count; ++i) {
    const auto [a, b, c] = fan_vertices(apex, count, i);
    const auto setup = setup_triangle({screen[a], screen[b], screen[c]});
    if (setup) for_each_covered(*setup, window, visit);
  }
}

}  // namespace glassbox
