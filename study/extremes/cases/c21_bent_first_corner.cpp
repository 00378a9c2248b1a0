#include "study/extremes/common/drawn_normals.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/polygons.h"
#include "study/naive/normals.h"

#include <glassbox/base/random.h>

namespace glassbox::study {
namespace c21 {

constexpr double kNoise = 1e-4;

Outcome measure_error(PolygonNormal normal) {
  Random random(721);
  const Vector<Object, exact::Rational> up(0, 0, 1);
  WorstError worst;
  for (const double bend : {1e-1, 1e-2, 1e-3, 1e-4}) {
    for (int i = 0; i < 50; ++i) {
      // A square of side 2 whose first three corners are almost on a line.
      const double outline[][2] = {{0, -1}, {0.5, -1 - bend}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
      Polygon polygon;
      for (const auto& [x, y] : outline) {
        const auto noise = [&] { return random.between(-kNoise, kNoise); };
        const double dx = noise(), dy = noise();
        polygon.emplace_back(float(x + dx), float(y + dy), float(noise()));
      }
      // Newell's vector is m = sum p_i x p_(i+1) over the corners p_i. If each corner moves by d_i,
      // m changes by sum d_i x (p_(i+1) - p_(i-1)) to first order. Here |d_i| <= sqrt(3) kNoise,
      // the diagonals p_(i+1) - p_(i-1) add up to at most twice the perimeter of 8.1, and |m| is
      // twice the area of 4. The second-order term is smaller by a factor of kNoise.
      const double bound = std::sqrt(3.0) * kNoise * 2 * 8.1 / 8 * 1.01;
      worst.add(angle_to(normal(polygon), up), bound, fmt::format("bend {:g}", bend), 1 / bend);
    }
  }
  return worst.outcome();
}

// Hexagons of this kind, each lit with a single normal, compared with the Newell vector of the same
// floats in rational numbers.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<NormalTestMesh> meshes = [] {
    Random random(821);
    std::vector<NormalTestMesh> all;
    for (const double bend : {1e-1, 1e-2, 1e-3, 1e-4}) {
      for (int i = 0; i < 4; ++i) {
        Polygon polygon;
        for (const auto& [x, y] : {std::pair{0.0, -0.8},
                                   {0.4, -0.8 - bend},
                                   {0.8, -0.8},
                                   {0.8, 0.8},
                                   {-0.8, 0.8},
                                   {-0.8, -0.8}}) {
          const auto noise = [&] { return random.between(-kNoise, kNoise); };
          const double dx = noise(), dy = noise();
          polygon.emplace_back(float(x + dx), float(y + dy), float(noise()));
        }
        all.push_back(make_normal_test_mesh(mesh_of(polygon), {}, exact_newell(polygon)));
      }
    }
    return all;
  }();
  return measure_normal_error(engine, meshes, Shading::kFlat, kShownNormal);
}

}  // namespace c21

ExtremeCase c21_bent_first_corner() {
  using namespace c21;
  return {
      .id = "C-21",
      .name = "First corners almost on a line",
      .construction =
          "hexagons of size 2 whose second corner sticks out by 0.1 .. 1e-4, all coordinates moved "
          "by up to 1e-4",
      .stage = "face normals",
      .right_answer =
          "the normal's error is the noise over the size, sqrt(3) s P / A = 3.5e-4, because "
          "Newell's sums use all corners",
      .unit = "radian",
      .oracle = Oracle::kExtended,
      .ours = {"newell_vector", [] { return measure_error(newell_in_double); }},
      .naive = {"the cross product of the first three corners",
                [] { return measure_error(naive::first_corner); }},
      .mutants = {{"the sums have an x in place of a y, or miss the last edge",
                   [] { return measure_error(naive::open_newell); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
