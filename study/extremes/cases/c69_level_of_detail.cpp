#include <glassbox/base/rounding.h>
#include <glassbox/raster/texture.h>

#include "study/extremes/common/attribute.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/ray_cast.h"

namespace glassbox::study {
namespace c69 {

constexpr int kSide = 256;
constexpr int kTexels = 1024;

using Texcoords = std::array<std::array<float, 2>, 3>;

// A narrow triangle that extends away from the viewer, with a texture; its texture coordinates are
// in the order of the setup's vertices.
struct Sheet {
  TriangleSetup setup;
  Texcoords texcoords;
};

std::vector<Sheet> sheets() {
  Camera camera;
  camera.lens = PerspectiveLens{1.0, 0.5, 1024};
  const View view = make_view(camera, kSide, kSide).value();
  std::vector<Sheet> all;
  for (int i = 0; i < 24; ++i) {
    const float x = float(i) - 12;
    const ScreenTriangle t{project(view, {x * 0.25f, -2, -4}),
                           project(view, {x * 0.25f + 0.2f, -2, -4}), project(view, {x, -2, -100})};
    const auto setup = setup_triangle(t);
    if (!setup) continue;
    const Texcoords given{{{0, 0}, {0.2f, 0}, {0.1f, 9}}};
    Sheet sheet{*setup, {}};
    for (std::size_t k = 0; k < 3; ++k) sheet.texcoords[k] = given[std::size_t(setup->order[k])];
    all.push_back(sheet);
  }
  return all;
}

// The derivative of a texture coordinate u = N/D per pixel along one axis, with N = sum E_k q_k
// (a_k - a_0) and D = sum E_k q_k: E_k are the edge functions, q_k = 1/w and a_k the coordinate at
// the vertices. `terms` is the sum of the absolute values of the derivative's terms, divided by D.
struct Derivative {
  double value = 0, terms = 0;
};
Derivative exact_derivative(const Sheet& sheet, const Coverage& pixel, bool along_y,
                            std::size_t i) {
  using Long = long double;
  Long n = 0, d = 0, dn = 0, dd = 0, size_dn = 0, size_dd = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Long q = Long(sheet.setup.inverse_w[k]);
    const Long a = Long(sheet.texcoords[k][i]) - Long(sheet.texcoords[0][i]);
    const Long step = Long((along_y ? sheet.setup.edges[k].b : sheet.setup.edges[k].a) * 256);
    n += Long(pixel.edges[k]) * q * a;
    d += Long(pixel.edges[k]) * q;
    dn += step * q * a;
    dd += step * q;
    size_dn += std::abs(step * q * a);
    size_dd += std::abs(step * q);
  }
  const Long u = n / d;
  return {double((dn - u * dd) / d), double((size_dn + std::abs(u) * size_dd) / d)};
}

struct ExactLevel {
  double level = 0, condition = 0;
};
ExactLevel exact_level(const Sheet& sheet, const Coverage& pixel) {
  double longest = 0, condition = 0;
  for (const bool along_y : {false, true}) {
    double squares = 0, terms = 0;
    for (std::size_t i = 0; i < 2; ++i) {
      const Derivative d = exact_derivative(sheet, pixel, along_y, i);
      squares += d.value * d.value;
      terms += d.terms * d.terms;
    }
    if (squares > longest) {
      longest = squares;
      condition = std::sqrt(terms / squares);
    }
  }
  return {std::log2(std::sqrt(longest) * kTexels), condition};
}

using LevelAt = std::function<std::optional<float>(const Sheet&, const Coverage&)>;

std::optional<float> pipeline_level(const Sheet& sheet, const Coverage& pixel) {
  const Fragment fragment = interpolate(sheet.setup, pixel);
  const auto& t = sheet.texcoords;
  const TextureGradient gradient =
      texture_gradient(texture_planes(sheet.setup, t),
                       interpolate(t[0], t[1], t[2], fragment.weights), fragment.inverse_w);
  return level_of_detail(gradient, kTexels, kTexels);
}

// Uses differences between neighbouring pixels of a 2 x 2 block, even if they show another
// triangle; where nothing is drawn, the coordinates are 0.
std::optional<float> level_by_neighbours(const Image<std::array<float, 2>>& texcoords, int x,
                                         int y) {
  const auto& here = texcoords.at(x, y);
  const auto& right = texcoords.at(x ^ 1, y);
  const auto& below = texcoords.at(x, y ^ 1);
  const TextureGradient gradient{{right[0] - here[0], right[1] - here[1]},
                                 {below[0] - here[0], below[1] - here[1]}};
  return level_of_detail(gradient, kTexels, kTexels);
}

Image<std::array<float, 2>> texcoord_picture() {
  Image<std::array<float, 2>> picture(kSide, kSide, {0, 0});
  for (const Sheet& sheet : sheets()) {
    const auto& t = sheet.texcoords;
    for_each_covered(sheet.setup, {0, 0, kSide, kSide}, [&](const Coverage& pixel) {
      picture.at(pixel.x, pixel.y) =
          interpolate(t[0], t[1], t[2], interpolate(sheet.setup, pixel).weights);
    });
  }
  return picture;
}

Outcome measure_error(const LevelAt& level_at) {
  WorstError worst;
  for (const Sheet& sheet : sheets()) {
    for_each_covered(sheet.setup, {0, 0, kSide, kSide}, [&](const Coverage& pixel) {
      const ExactLevel exact = exact_level(sheet, pixel);
      // With the unit roundoff u, the relative errors are 6 u for the slopes, 14 u for the
      // coordinate, 3 u for their product and difference, 8 u for w and 3 u for the length: 34 u of
      // `terms`. In levels, a relative change is multiplied by 1/ln 2. The logarithm itself may
      // have an error of 5e-8 and two rounding errors.
      const double u = double(unit_roundoff<float>);
      const double bound = 34 * u * exact.condition / 0.693 + 5e-8 + 4 * u * std::abs(exact.level);
      const auto level = level_at(sheet, pixel);
      worst.add(level ? std::abs(double(*level) - exact.level) : HUGE_VAL, bound,
                fmt::format("level {:.4f} instead of {:.4f}", level.value_or(0), exact.level),
                exact.condition);
    });
  }
  return worst.outcome();
}

Outcome measure_naive_error() {
  const auto texcoords = texcoord_picture();
  return measure_error([&](const Sheet&, const Coverage& pixel) {
    return level_by_neighbours(texcoords, pixel.x, pixel.y);
  });
}

// Uses plane equations on the screen, but ignores that 1/w changes from pixel to pixel.
std::optional<float> level_without_perspective(const Sheet& sheet, const Coverage& pixel) {
  const Fragment fragment = interpolate(sheet.setup, pixel);
  const auto& t = sheet.texcoords;
  TexturePlanes planes = texture_planes(sheet.setup, t);
  planes.inverse_w = {0, 0};
  return level_of_detail(
      texture_gradient(planes, interpolate(t[0], t[1], t[2], fragment.weights), fragment.inverse_w),
      kTexels, kTexels);
}

// Tests the level of detail by the stripes of a texture that are still visible at that level.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const RayCastReference strips([] {
    std::vector<EyeTriangle> triangles;
    std::vector<Texcoords> texcoords;
    for (int i = 0; i < 12; ++i) {
      const float x = float(i) - 6;
      triangles.push_back(
          {Point<Eye>{x * 0.3f, -2, -4}, {x * 0.3f + 0.25f, -2, -4}, {x, -2, -100}});
      texcoords.push_back({{{0, 0}, {0.2f, 0}, {0.1f, 9}}});
      triangles.push_back({Point<Eye>{2, x * 0.3f, -4}, {2, x * 0.3f + 0.25f, -4}, {2, x, -100}});
      texcoords.push_back({{{0, 0}, {0.002f, 0}, {0.001f, 0.9f}}});
    }
    const Point<Eye> a{-3, 0, -3}, b{3, 0.2f, -4}, c{0, 2.5f, -9};
    triangles.push_back({a, b, c});
    texcoords.push_back({{{0, 0}, {0.4f, 0.1f}, {0.3f, 0.7f}}});
    return striped_ray_scene(triangles, texcoords, PerspectiveLens{1.0, 0.5, 1024.0}, 128, kTexels);
  }());
  return strips.measure_error(engine);
}

}  // namespace c69

ExtremeCase c69_level_of_detail() {
  using namespace c69;
  return {
      .id = "C-69",
      .name = "Level of detail at outlines",
      .construction =
          "24 narrow strips with 1,024 texels that run away from the viewer, with gaps between "
          "them",
      .stage = "texture",
      .right_answer =
          "the derivative of the plane equations, to 34 u of its terms, without looking at "
          "neighbouring pixels",
      .unit = "levels",
      .oracle = Oracle::kRational,
      .ours = {"analytic derivatives", [] { return measure_error(pipeline_level); }},
      .naive = {"differences to neighbours in the picture", measure_naive_error},
      .mutants = {{"1/w is taken as constant",
                   [] { return measure_error(level_without_perspective); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
