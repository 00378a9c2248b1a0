#include <glassbox/pipeline/api_dialects.h>
#include <glassbox/pipeline/clip.h>

#include "study/extremes/common/extreme_case.h"

namespace glassbox::study {
namespace c41 {

// Chooses the near clip plane for vertices that follow the conventions of a graphics API.
using NearPlane = ClipPlane (*)(const ApiDialect&);

Outcome measure_error(NearPlane near_plane) {
  constexpr double n = 1, f = 1024;
  int wrong = 0, points = 0;
  for (const char* name : {"opengl", "d3d"}) {
    const ApiDialect& dialect = *find_dialect(name);
    const ClipPlane plane = near_plane(dialect);
    for (const double depth : {0.25, 0.5, 0.75, 0.99, 1.0, 1.01, 1.5, 1.99, 2.5, 100.0, 1e30}) {
      const double z = dialect.z_from_minus_w ? ((f + n) * depth - 2 * f * n) / (f - n)
                                              : f * (depth - n) / (f - n);
      const Point<Clip> p{0, 0, float(z), float(depth)};
      wrong += clip_point(p, {&plane, 1}) != (depth >= n);
      ++points;
    }
  }
  return wrong_count_outcome(wrong, points, "points are on the wrong side of the near plane");
}

ClipPlane near_plane_of_dialect(const ApiDialect& dialect) {
  return clip_planes(dialect)[0];
}
ClipPlane always_zero(const ApiDialect&) {
  return frustum_planes()[0];
}
ClipPlane always_minus_w(const ApiDialect&) {
  return opengl_near_plane();
}

}  // namespace c41

ExtremeCase c41_near_plane_dialects() {
  using namespace c41;
  return {
      .id = "C-41",
      .name = "Near planes of two dialects",
      .construction =
          "near plane 1, far plane 1024; points at distances 0.25 .. 1e30, projected by OpenGL's "
          "and Direct3D's matrices",
      .stage = "clip",
      .right_answer =
          "points are visible from the near plane on; the plane of the other API cuts at 2 n f/(f "
          "+ n), or at n f/(2 f - n) (erratum E16)",
      .unit = "points",
      .oracle = Oracle::kRational,
      .ours = {"clip_planes of the dialect", [] { return measure_error(near_plane_of_dialect); }},
      .naive = {"z >= 0 for every dialect", [] { return measure_error(always_zero); }},
      .mutants = {{"z >= -w for every dialect", [] { return measure_error(always_minus_w); }}},
      .not_drawn = "the renderer has only one clip space, so it cannot draw the other one",
  };
}

}  // namespace glassbox::study
