#include "study/extremes/kit/attribute.h"
#include "study/extremes/kit/extreme_case.h"
#include "study/naive/attribute.h"

namespace glassbox::study {
namespace c65 {

constexpr int kSide = 512;

// A floor 1.5 under the eye, from 4 to 4,000 away: seen under 0.02 degrees at its far end. u runs along the gaze.
JudgedTriangle floor_triangle() {
  Camera camera;
  camera.lens = PerspectiveLens{1.0, 0.5, 8192};
  const View view = make_view(camera, kSide, kSide).value();
  return {{project(view, {-2, -1.5f, -4}), project(view, {2, -1.5f, -4}),
           project(view, {0, -1.5f, -4000})},
          {0, 0, 1}};
}

Outcome judge(const AttributeAt& at) {
  return judge_attribute(at, floor_triangle(), kSide, 1);
}

Image<Rgba8> checks(const AttributeAt& at) {
  const JudgedTriangle floor = floor_triangle();
  const auto setup = setup_triangle(floor.triangle);
  Image<Rgba8> picture(kSide, kSide, {200, 220, 235, 255});
  std::array<float, 3> values;
  for (std::size_t k = 0; k < 3; ++k) values[k] = floor.values[std::size_t(setup->order[k])];
  for_each_covered(*setup, {0, 0, kSide, kSide}, [&](const Coverage& pixel) {
    const bool dark = int(std::floor(double(at(*setup, pixel, values)) * 2048)) % 2 != 0;
    picture.at(pixel.x, pixel.y) = dark ? Rgba8{36, 40, 52, 255} : Rgba8{232, 228, 216, 255};
  });
  return picture;
}

}  // namespace c65

ExtremeCase c65_floor_to_horizon() {
  using namespace c65;
  return {
      .id = "C-65",
      .name = "Floor to the horizon",
      .construction = "a floor 1.5 under the eye, from 4 to 4,000 away, u from 0 to 1 along it",
      .stage = "interpolate",
      .right =
          "13 u (w1 |u1 - u0| + w2 |u2 - u0|) + u |u| (raster/interpolate.h). Without perspective "
          "up to (sqrt r - 1)/(sqrt r + 1) = 0.94 for r = 1,000 (B.11)",
      .unit = "of the texture",
      .oracle = Oracle::kRational,
      .ours = {"u/w over 1/w", [] { return judge(pipeline_attribute); }},
      .naive = {"affine interpolation", [] { return judge(naive::affine); }},
      .mutants = {{"u/w times an interpolated w", [] { return judge(naive::with_linear_w); }}},
      .pictures = {{"naive", [] { return png_of(checks(naive::affine)); }},
                   {"ours", [] { return png_of(checks(pipeline_attribute)); }}},
  };
}

}  // namespace glassbox::study
