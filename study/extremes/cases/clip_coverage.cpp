#include "study/extremes/cases/clip_coverage.h"

#include <glassbox/pipeline/divide.h>
#include <glassbox/raster/coverage.h>
#include <glassbox/raster/fan.h>
#include <glassbox/raster/snap.h>

namespace glassbox::study {

void visit_covered(const Outline& outline, const Viewport& viewport, const PixelRect& window,
                   const std::function<void(int x, int y)>& visit) {
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
    if (!setup) continue;
    for_each_covered(*setup, window, [&](const Coverage& pixel) { visit(pixel.x, pixel.y); });
  }
}

}  // namespace glassbox::study
