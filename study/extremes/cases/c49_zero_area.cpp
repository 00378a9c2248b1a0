#include <glassbox/base/random.h>
#include <glassbox/raster/coverage.h>
#include <glassbox/raster/interpolate.h>

#include "study/extremes/common/coverage.h"
#include "study/extremes/common/drawn_coverage.h"
#include "study/extremes/common/extreme_case.h"
#include "study/naive/coverage.h"

namespace glassbox::study {
namespace c49 {

constexpr int kSide = 64;

// Triangles around an inner quad that is 1/1024 px thin: after snapping, the two triangles of the
// quad have no area.
std::vector<ScreenTriangle> mesh(Random& random) {
  const double y = random.between(20, 44), dy = random.between(-3, 3);
  const auto v = [](double x, double at) { return screen_vertex(x, at); };
  const auto left = v(-2, y), right = v(66, y + dy);
  const auto middle = v(32, y + dy / 2 + 0x1p-11), below = v(32, y + dy / 2 + 0x1p-10);
  const auto a = v(-2, -2), b = v(66, -2), c = v(66, 66), d = v(-2, 66);
  return {{a, b, right},          {a, right, middle}, {a, middle, left}, {left, middle, below},
          {middle, right, below}, {left, below, d},   {below, right, c}, {below, c, d}};
}

// Draws a triangle: calls the visitor for each covered pixel with its first barycentric weight.
using Draws =
    std::function<void(const ScreenTriangle&, const std::function<void(int, int, float)>&)>;

void pipeline_draws(const ScreenTriangle& t, const std::function<void(int, int, float)>& visit) {
  const auto setup = setup_triangle(t);
  if (!setup) return;
  for_each_covered(*setup, {0, 0, kSide, kSide}, [&](const Coverage& pixel) {
    visit(pixel.x, pixel.y, interpolate(*setup, pixel).weights[0]);
  });
}

// Drops no triangle. The weights are edge functions divided by the area, which is 0/0 if a triangle
// has become a line by snapping.
void draws_without_dropping(const ScreenTriangle& t,
                            const std::function<void(int, int, float)>& visit) {
  const SnappedTriangle v = exact::snapped(t);
  const auto cross = [](const SnappedVertex& a, const SnappedVertex& b, double x, double y) {
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
  };
  const double area = cross(v[0], v[1], v[2].x, v[2].y);
  const double turn = area < 0 ? -1 : 1;
  const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
  for (int y = std::max(0, top / 256); y < std::min(kSide, bottom / 256 + 1); ++y) {
    for (int x = 0; x < kSide; ++x) {
      const double px = x * 256 + 128, py = y * 256 + 128;
      const std::array<double, 3> e{cross(v[1], v[2], px, py) * turn,
                                    cross(v[2], v[0], px, py) * turn,
                                    cross(v[0], v[1], px, py) * turn};
      if (e[0] >= 0 && e[1] >= 0 && e[2] >= 0) visit(x, y, float(e[0] / (area * turn)));
    }
  }
}

// Drops triangles of less than 256 square pixels as too small, although they may cover pixels.
void drops_small_ones(const ScreenTriangle& t, const std::function<void(int, int, float)>& visit) {
  const SnappedTriangle v = exact::snapped(t);
  const std::int64_t area = std::int64_t(v[1].x - v[0].x) * (v[2].y - v[0].y) -
                            std::int64_t(v[2].x - v[0].x) * (v[1].y - v[0].y);
  if (std::abs(area) >= std::int64_t(512) * kSubpixels * kSubpixels) pipeline_draws(t, visit);
}

Outcome measure_error(const Draws& draws) {
  Random random(49);
  Watertightness found;
  std::int64_t lines = 0, not_numbers = 0;
  for (int i = 0; i < 200; ++i) {
    Image<int> times(kSide, kSide);
    for (const ScreenTriangle& t : mesh(random)) {
      const SnappedTriangle v = exact::snapped(t);
      lines += std::int64_t(v[1].x - v[0].x) * (v[2].y - v[0].y) ==
               std::int64_t(v[2].x - v[0].x) * (v[1].y - v[0].y);
      draws(t, [&](int x, int y, float weight) {
        ++times.at(x, y);
        not_numbers += !std::isfinite(weight);
      });
    }
    found.add(times);
  }
  const std::int64_t faults = found.gaps + found.doubles;
  return must_be_zero(double(faults + not_numbers),
                      fmt::format("{} triangles have no area; {} pixels are not covered exactly "
                                  "once, {} weights are not numbers",
                                  lines, faults, not_numbers));
}

Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<CoverageReference> meshes = [] {
    Random random(149);
    std::vector<CoverageReference> all;
    for (int i = 0; i < 24; ++i) all.emplace_back(mesh(random), kSide);
    return all;
  }();
  return worst_of(meshes, engine);
}

}  // namespace c49

ExtremeCase c49_zero_area() {
  using namespace c49;
  return {
      .id = "C-49",
      .name = "No area after snapping",
      .construction =
          "200 meshes of eight triangles, two of which are 2^-11 px high and 68 px long, so that "
          "the snap turns most of them into lines",
      .stage = "setup",
      .right_answer =
          "such triangles are dropped, because they cover no pixel; their neighbours stay "
          "watertight",
      .unit = "pixels",
      .oracle = Oracle::kInteger,
      .ours = {"triangles without area are dropped at setup",
               [] { return measure_error(pipeline_draws); }},
      .naive = {"triangles without area are not dropped",
                [] { return measure_error(draws_without_dropping); }},
      .mutants = {{"triangles with an area below 256 px are dropped",
                   [] { return measure_error(drops_small_ones); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
