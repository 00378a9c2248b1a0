#include <glassbox/base/rounding.h>
#include <glassbox/raster/coverage.h>
#include <glassbox/raster/interpolate.h>

#include "study/extremes/common/coverage.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/ray_cast.h"

namespace glassbox::study {
namespace c54 {

constexpr int kWidth = 32767;

// Computes u = x / kWidth along the middle row of a triangle that is as wide as the picture, and
// calls visit(x, u).
using Span = std::function<void(const std::function<void(int, float)>&)>;

const ScreenTriangle kTriangle{screen_vertex(0, -1), screen_vertex(kWidth, 0.5),
                               screen_vertex(0, 2)};

void pipeline_span(const std::function<void(int, float)>& visit) {
  const auto setup = setup_triangle(kTriangle);
  const std::array<std::array<float, 1>, 3> u{{{0}, {1}, {0}}};
  const auto at = [&](std::size_t k) { return u[std::size_t(setup->order[k])]; };
  for_each_covered(*setup, {0, 0, kWidth, 1}, [&](const Coverage& pixel) {
    const Fragment fragment = interpolate(*setup, pixel);
    visit(pixel.x, interpolate(at(0), at(1), at(2), fragment.weights)[0]);
  });
}

// Adds the increment of u once per pixel: every rounding error stays in the sum, and all errors
// have the same sign.
void stepped_span(const std::function<void(int, float)>& visit) {
  const float step = 1.0f / float(kWidth);
  float u = 0.5f * step;
  for (int x = 0; x < kWidth; ++x, u += step) visit(x, u);
}

// Adds the increment of u once per pixel, but starts again from the exact value every `anchor`
// pixels.
void anchored_span(int anchor, const std::function<void(int, float)>& visit) {
  const float step = 1.0f / float(kWidth);
  for (int x = 0; x < kWidth; ++x) {
    const int anew = x / anchor * anchor;
    float u = (float(anew) + 0.5f) * step;
    for (int i = 0; i < x % anchor; ++i) u += step;
    visit(x, u);
  }
}

Outcome measure_error(const Span& span) {
  double worst = 0;
  int worst_x = 0, pixels = 0;
  span([&](int x, float u) {
    // The exact u is a quotient of integers, right to 2^-53.
    const double exact = (x + 0.5) / kWidth;
    const double error = std::abs(double(u) - exact) / exact;
    ++pixels;
    if (error > worst) {
      worst = error;
      worst_x = x;
    }
  });
  if (pixels < kWidth - 1) return must_be_zero(HUGE_VAL, fmt::format("only {} pixels", pixels));
  return {worst / double(unit_roundoff<float>),
          14,
          {},
          fmt::format("{:.2g} relative at column {}", worst, worst_x)};
}

// A row as wide as a picture may be, with a texture that has as many texels: each pixel has its own
// texel, so no step may be lost.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const RayCastReference row = [] {
    const float half = float(kMaxImageSide) / 2;
    const Lens lens = OrthographicLens{0.5, 0, 2};
    RayScene ray_scene = textured_ray_scene(
        {{Point<Eye>{-half, -1.5f, -1}, {half, 0, -1}, {-half, 1.5f, -1}}},
        {{{{0, 0}, {1, 0.5f}, {0, 1}}}}, lens, 1, {kMaxImageSide, 1}, Wrap::kClampToEdge);
    Camera camera;
    camera.lens = lens;
    ray_scene.view = make_view(camera, kMaxImageSide, 1).value();
    return RayCastReference(std::move(ray_scene));
  }();
  return row.measure_error(engine);
}

}  // namespace c54

ExtremeCase c54_stepping() {
  using namespace c54;
  return {
      .id = "C-54",
      .name = "Incremental stepping over 32 K",
      .construction = "a texture coordinate from 0 to 1 over a span of 32,767 px",
      .stage = "interpolate",
      .right_answer =
          "the relative error is at most 14 u, because edge functions are stepped as integers, and "
          "the weights of every pixel are computed from them",
      .unit = "2^-24 relative",
      .oracle = Oracle::kRational,
      .ours =
          {"integers are stepped from pixel to pixel, and floats are computed anew for each pixel",
           [] { return measure_error(pipeline_span); }},
      .naive = {"u += du in float", [] { return measure_error(stepped_span); }},
      .mutants = {{"floats are stepped, and computed anew only every 1024 pixels",
                   [] {
                     return measure_error([](const auto& visit) { anchored_span(1024, visit); });
                   }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
