#include "study/extremes/common/attribute.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/ray_cast.h"
#include "study/naive/attribute.h"

namespace glassbox::study {
namespace c65 {

constexpr int kSide = 512;

// A floor 1.5 units below the eye, from 4 to 4,000 units away: its far end is seen at an angle of
// 0.02 degrees. The attribute grows along the gaze from 0 to 1.
AttributeTriangle floor_triangle() {
  Camera camera;
  camera.lens = PerspectiveLens{1.0, 0.5, 8192};
  const View view = make_view(camera, kSide, kSide).value();
  return {{project(view, {-2, -1.5f, -4}), project(view, {2, -1.5f, -4}),
           project(view, {0, -1.5f, -4000})},
          {0, 0, 1}};
}

Outcome measure_error(const AttributeAt& at) {
  return measure_attribute_error(at, floor_triangle(), kSide, 1);
}

Image<Rgba8> checks(const AttributeAt& at) {
  const AttributeTriangle floor = floor_triangle();
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

// A floor of 60 x 20 squares with two small triangles each; every 2 x 2 squares share a texture of
// 16 x 16 texels.
RayScene tiled_floor() {
  std::vector<EyeTriangle> triangles;
  std::vector<Texcoords> texcoords;
  for (int row = 0; row < 60; ++row) {
    for (int column = 0; column < 20; ++column) {
      const auto at = [&](int i, int j) {
        return Point<Eye>{float(column + i - 10) * 0.25f, -1.5f, -2 - float(row + j) * 0.5f};
      };
      const auto uv = [&](int i, int j) {
        return std::array{float(column + i) / 2, float(row + j) / 2};
      };
      // The triangles of odd and even columns start at different corners, so that either of the two
      // corners with the same w may be the first.
      if (column % 2 == 0) {
        triangles.push_back({at(0, 0), at(1, 0), at(1, 1)});
        texcoords.push_back({uv(0, 0), uv(1, 0), uv(1, 1)});
      } else {
        triangles.push_back({at(1, 0), at(1, 1), at(0, 0)});
        texcoords.push_back({uv(1, 0), uv(1, 1), uv(0, 0)});
      }
      triangles.push_back({at(0, 0), at(1, 1), at(0, 1)});
      texcoords.push_back({uv(0, 0), uv(1, 1), uv(0, 1)});
    }
  }
  return textured_ray_scene(triangles, texcoords, PerspectiveLens{1.0, 0.5, 64.0}, 256, {16, 16},
                            Wrap::kRepeat);
}

Outcome measure_drawn_error(const TestedEngine& engine) {
  static const RayCastReference tiles(tiled_floor());
  static const std::vector<RayCastReference> floors = [] {
    // A long floor with 2,048 texels along it, each with its own colour. The triangle starts at
    // each of its corners in turn, so that the order of two vertices with equal w is not always the
    // same.
    EyeTriangle floor{Point<Eye>{-2, -1.5f, -4}, {2, -1.5f, -4}, {0, -1.5f, -4000}};
    Texcoords texcoords{{{0, 0}, {0, 1}, {1, 0.5f}}};
    std::vector<RayCastReference> all;
    for (int turn = 0; turn < 3; ++turn) {
      all.emplace_back(textured_ray_scene({floor}, {texcoords}, PerspectiveLens{1.0, 0.5, 8192.0},
                                          128, {2048, 4}, Wrap::kClampToEdge));
      std::rotate(floor.begin(), floor.begin() + 1, floor.end());
      std::rotate(texcoords.begin(), texcoords.begin() + 1, texcoords.end());
    }
    return all;
  }();
  return worse_of(tiles.measure_error(engine), worst_of(floors, engine));
}

}  // namespace c65

ExtremeCase c65_floor_to_horizon() {
  using namespace c65;
  return {
      .id = "C-65",
      .name = "Floor to the horizon",
      .construction =
          "a floor 1.5 below the eye, from 4 to 4,000 away; the texture coordinate u is 0 to 1 "
          "along it",
      .stage = "interpolate",
      .right_answer =
          "the error is at most 13 e (w1 |u1 - u0| + w2 |u2 - u0|) + e |u| with the unit roundoff "
          "e = 2^-24 (raster/interpolate.h); without perspective it is up to (sqrt r - 1)/(sqrt r "
          "+ 1) = 0.94 for r = 1,000 (B.11)",
      .unit = "of the texture",
      .oracle = Oracle::kRational,
      .ours = {"u/w divided by 1/w", [] { return measure_error(pipeline_attribute); }},
      .naive = {"affine interpolation", [] { return measure_error(naive::affine); }},
      .mutants = {{"u/w times an interpolated w",
                   [] { return measure_error(naive::with_linear_w); }}},
      .drawn = measure_drawn_error,
      .pictures = {{"naive", [] { return png_of(checks(naive::affine)); }},
                   {"ours", [] { return png_of(checks(pipeline_attribute)); }}},
  };
}

}  // namespace glassbox::study
