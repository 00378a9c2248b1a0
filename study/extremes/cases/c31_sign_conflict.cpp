#include <glassbox/base/random.h>
#include <glassbox/mesh/normals.h>
#include <glassbox/pipeline/affine.h>

#include "study/extremes/common/drawn_normals.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/polygons.h"
#include "study/naive/normals.h"

namespace glassbox::study {
namespace c31 {

Outcome measure_error(PolygonNormal normal) {
  Random random(731);
  int opposite = 0;
  constexpr int kTriangles = 1000;
  for (int i = 0; i < kTriangles; ++i) {
    Polygon triangle(3);
    for (Point<Object>& p : triangle) {
      p = {float(random.integer(-99, 99)), float(random.integer(-99, 99)),
           float(random.integer(-99, 99))};
    }
    // Coordinates are small integers, so every product and sum is exact in float.
    const auto exact = exact_newell(triangle);
    const auto m = normal(triangle);
    opposite += m.x != double(exact.x) || m.y != double(exact.y) || m.z != double(exact.z);
  }
  return wrong_count_outcome(opposite, kTriangles, "vectors differ from Newell's");
}

Vector<Object, double> ours(std::span<const Point<Object>> t) {
  const auto m = three_point_normal(t[0], t[1], t[2]);
  return {m.x, m.y, m.z};
}
Vector<Object, double> factors_exchanged(std::span<const Point<Object>> t) {
  const auto m = cross(t[2] - t[1], t[1] - t[0]);
  return {m.x, m.y, m.z};
}

// Triangles turned so that Newell's vector points to the viewer: all must be visible, in the colour
// of that vector.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<NormalTestMesh> meshes = [] {
    Random random(831);
    std::vector<NormalTestMesh> all;
    while (all.size() < 49) {
      Polygon triangle(3);
      for (Point<Object>& p : triangle) {
        p = {float(random.integer(-99, 99)), float(random.integer(-99, 99)),
             float(random.integer(-99, 99))};
      }
      auto normal = exact_newell(triangle);
      // Skips triangles that cover less than a fifth of the square.
      if (abs(normal.z) < exact::Rational(4000)) continue;
      if (normal.z.sign() < 0) std::swap(triangle[0], triangle[1]);
      all.push_back(make_normal_test_mesh(mesh_of(triangle), scale<World, Object>(0.01, 0.01, 0.01),
                                          exact_newell(triangle)));
    }
    return all;
  }();
  return measure_normal_error(engine, meshes, Shading::kFlat, kShownNormal);
}

}  // namespace c31

ExtremeCase c31_sign_conflict() {
  using namespace c31;
  return {
      .id = "C-31",
      .name = "Two formulas of one deck with opposite signs",
      .construction = "1000 triangles of integers, by S4.32's cross product and S4.33's sums",
      .stage = "face normals",
      .right_answer =
          "the cross product (V2 - V1) x (V3 - V2) equals Newell's vector exactly (E11)",
      .unit = "triangles",
      .oracle = Oracle::kRational,
      .ours = {"three_point_normal", [] { return measure_error(ours); }},
      .naive = {"S4.32: (V1 - V2) x (V3 - V2)", [] { return measure_error(naive::slide_32); }},
      .mutants = {{"the factors of the cross product are exchanged",
                   [] { return measure_error(factors_exchanged); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
