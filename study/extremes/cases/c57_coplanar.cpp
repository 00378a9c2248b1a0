#include "study/extremes/kit/depth.h"
#include "study/extremes/kit/extreme_case.h"
#include "study/naive/depth.h"

#include <glassbox/base/random.h>

namespace glassbox::study {
namespace c57 {

constexpr int kSide = 4096;

// The plane has depths that float holds exactly at whole pixels.
double plane_at(double x, double y) {
  return 0.25 + x * 0x1p-14 + y * 0x1p-15;
}

ScreenTriangle random_triangle(Random& random) {
  ScreenTriangle t;
  for (ScreenVertex& v : t) {
    const double x = double(random.integer(0, kSide)), y = double(random.integer(0, kSide));
    v = screen_vertex(x, y, float(plane_at(x, y)));
  }
  return t;
}

Outcome judge(const DepthAt& depth) {
  Random random(57);
  ErrorsBeyond errors(8);
  for (int i = 0; i < 300; ++i) {
    const auto setup = setup_triangle(random_triangle(random));
    if (!setup) continue;
    // Some rows of each, whole.
    for (int row = 0; row < 4; ++row) {
      const int y = int(random.integer(0, kSide - 1));
      for_each_covered(*setup, {0, y, kSide, y + 1}, [&](const Coverage& pixel) {
        const double exact = plane_at(pixel.x + 0.5, pixel.y + 0.5);
        errors.see(std::abs(double(depth(*setup, pixel)) - exact) / exact * 0x1p24);
      });
    }
  }
  return errors.outcome("samples beyond 8 u");
}

}  // namespace c57

ExtremeCase c57_coplanar() {
  using namespace c57;
  return {
      .id = "C-57",
      .name = "One plane, other triangles",
      .construction =
          "300 random triangles of the plane 1/4 + x/2^14 + y/2^15, with vertices on whole pixels "
          "of 4096 x 4096, where depth is exact",
      .stage = "interpolate",
      .right =
          "8 u of the plane (raster/interpolate.h), so that two triangles differ by 16 u at most; "
          "of equal depths the first stays",
      .unit = "2^-24 relative",
      .oracle = Oracle::kRational,
      .ours = {"weights, differences from the nearest vertex",
               [] { return judge(pipeline_depth); }},
      .naive = {"d = A x + B y + C in float", [] { return judge(naive::plane_depth); }},
      .mutants = {{"gradients from the corner of the box",
                   [] { return judge(naive::depth_from_corner); }}},
  };
}

}  // namespace glassbox::study
