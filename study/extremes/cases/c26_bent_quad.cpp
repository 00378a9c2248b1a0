#include <glassbox/base/rounding.h>
#include <glassbox/mesh/triangulate.h>
#include <bit>

#include <array>
#include <set>

#include "study/extremes/common/drawn_coverage.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/polygons.h"
#include "study/extremes/common/screen_scene.h"
#include "study/naive/normals.h"

namespace glassbox::study {
namespace c26 {

using exact::Decimal;

struct QuadFunctions {
  double (*deviation)(const Polygon&);                            // distance from the mean plane
  std::array<std::size_t, 2> (*diagonal)(const Polygon& square);  // the two corners that it joins
};

Outcome measure_error(auto deviation_by, auto diagonal_by) {
  const QuadFunctions quads{deviation_by, diagonal_by};
  WorstError worst;
  int unsteady = 0;
  for (const float h : {0.5f, 0x1p-5f, 0x1p-10f}) {
    const Polygon square{{0, 0, 0}, {1, 0, 0}, {1, 1, h}, {0, 1, 0}};
    std::set<std::set<std::pair<float, float>>> diagonals;
    for (std::size_t first = 0; first < 4; ++first) {
      Polygon turned;
      for (std::size_t i = 0; i < 4; ++i) turned.push_back(square[(first + i) % 4]);
      // Newell's vector is m = (-h, -h, 2). The corners' distance from the plane through their mean
      // is +-(h/2)/|m|, which is h/4 to first order in h.
      const Decimal height{double(h)};
      const Decimal exact =
          height / Decimal(2) / exact::sqrt(Decimal(2) * height * height + Decimal(4));
      // The bound in double is gamma_12: a dozen rounding errors of numbers up to 1.
      worst.add(exact::error_of(quads.deviation(turned), exact), gamma<double>(12),
                fmt::format("corner lifted by {:g}", h));
      const auto [a, b] = quads.diagonal(turned);
      using Corner2 = std::pair<float, float>;
      diagonals.insert({Corner2(turned[a].x, turned[a].y), Corner2(turned[b].x, turned[b].y)});
    }
    unsteady += diagonals.size() != 1;
  }
  if (unsteady > 0) worst.add(HUGE_VAL, 0, "the diagonal depends on where the list begins");
  return worst.outcome(fmt::format("{} of 3 diagonals depend on the first corner", unsteady));
}

double deviation_from_mean_plane(const Polygon& polygon) {
  const Mesh mesh = mesh_of(polygon);
  return planarity_deviation(mesh, mesh.faces[0]);
}
std::array<std::size_t, 2> shared_corners(const Polygon& polygon) {
  const auto triangles = triangulate(mesh_of(polygon)).triangles;
  if (triangles.size() != 2) return {0, 0};
  std::array<std::size_t, 2> shared{};
  std::size_t count = 0;
  for (const std::uint32_t c : triangles[0].corners) {
    const auto& other = triangles[1].corners;
    if (count < 2 && std::find(other.begin(), other.end(), c) != other.end()) shared[count++] = c;
  }
  return shared;
}

// The distance of the fourth corner from the plane of the other three.
double deviation_from_first_three(const Polygon& polygon) {
  const auto m = naive::first_corner(polygon);
  const auto off = polygon[3] - polygon[0];
  return std::abs(m.x * double(off.x) + m.y * double(off.y) + m.z * double(off.z)) /
         std::sqrt(dot(m, m));
}
std::array<std::size_t, 2> from_the_first_corner(const Polygon&) {
  return {0, 2};
}

// A square with one lifted corner, seen from above with 32 px per side: the stored depths must be
// those of the square folded along its shorter diagonal, from (1, 0) to (0, 1), wherever the list
// of corners begins. Depth is 1/2 - z/2, exactly at the corners; the bound is 8 u of the depth
// (C-57; u is the unit roundoff).
Outcome measure_drawn_error(const TestedEngine& engine) {
  Camera camera;
  camera.lens = OrthographicLens{1, 0, 2};
  camera.world_from_eye.at(2, 3) = 1;
  const View view = make_view(camera, 64, 64).value();
  RenderSettings settings = plain_settings();
  settings.want_depth = true;
  WorstError worst;
  for (const float h : {0.5f, 0x1p-5f, 0x1p-10f}) {
    const Polygon square{{0, 0, 0}, {1, 0, 0}, {1, 1, h}, {0, 1, 0}};
    for (std::size_t first = 0; first < 4; ++first) {
      Polygon turned;
      for (std::size_t i = 0; i < 4; ++i) turned.push_back(square[(first + i) % 4]);
      const Framebuffer found =
          engine.draw(scene_of(mesh_of(turned), unlit_material()), view, settings).buffers;
      for (int row = 1; row < 31; ++row) {
        for (int column = 33; column < 63; ++column) {
          const double x = (column + 0.5 - 32) / 32, y = (32 - row - 0.5) / 32;
          const double right = 0.5 - double(h) * std::max(0.0, x + y - 1) / 2;
          const auto depth = double(std::bit_cast<float>(found.depth.at(column, row)));
          worst.add(found.id.at(column, row) == 0 ? HUGE_VAL : std::abs(depth - right) / right,
                    8 * unit_roundoff<float>, fmt::format("corner lifted by {:g}", h));
        }
      }
    }
  }
  return worst.outcome();
}

}  // namespace c26

ExtremeCase c26_bent_quad() {
  using namespace c26;
  return {
      .id = "C-26",
      .name = "A quad that is not flat",
      .construction =
          "a unit square with one corner lifted by 1/2, 1/32 or 1/1024, with each corner as the "
          "first one",
      .stage = "triangulation",
      .right_answer =
          "the corners are (h/2)/sqrt(4 + 2 h^2) from the mean plane, to 12 roundings; the shorter "
          "diagonal is chosen, whichever corner comes first",
      .unit = "object unit",
      .oracle = Oracle::kExtended,
      .ours = {"planarity_deviation and triangulate",
               [] { return measure_error(deviation_from_mean_plane, shared_corners); }},
      .naive = {"the plane of the first three corners, and the diagonal from the first corner",
                [] { return measure_error(deviation_from_first_three, from_the_first_corner); }},
      .mutants = {{"the diagonal always begins at the first corner",
                   [] { return measure_error(deviation_from_mean_plane, from_the_first_corner); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
