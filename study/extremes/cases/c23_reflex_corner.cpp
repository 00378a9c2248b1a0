#include <glassbox/pipeline/affine.h>
#include "study/extremes/common/drawn_normals.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/polygons.h"
#include "study/naive/normals.h"

namespace glassbox::study {
namespace c23 {

Outcome measure_error(PolygonNormal normal) {
  // An arrow head, counter-clockwise. Its list of corners starts at each of the four corners in
  // turn; in one of these lists the second corner is reflex (its inner angle is above 180 degrees).
  const Polygon arrow{{0, 0, 0}, {2, 0, 0.5f}, {0.25f, 0.5f, 0.0625f}, {0, 2, 0}};
  int reversed = 0, all = 0;
  for (const float size : {1.0f, 1e-3f, 1e3f}) {
    for (std::size_t first = 0; first < arrow.size(); ++first) {
      Polygon turned;
      for (std::size_t i = 0; i < arrow.size(); ++i) {
        const Point<Object>& p = arrow[(first + i) % arrow.size()];
        turned.emplace_back(p.x * size, p.y * size, p.z * size);
      }
      const auto exact = exact_newell(turned);
      const auto m = normal(turned);
      reversed += !(m.z * double(exact.z) > 0);
      ++all;
    }
  }
  return wrong_count_outcome(reversed, all, "normals are reversed");
}

// The arrow heads, each with a list that starts at another corner. They must be visible, because a
// reversed normal would make them back faces, and they must have their own colour.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<NormalTestMesh> meshes = [] {
    const Polygon arrow{{0, 0, 0}, {2, 0, 0.5f}, {0.25f, 0.5f, 0.0625f}, {0, 2, 0}};
    std::vector<NormalTestMesh> all;
    for (const float size : {1.0f, 1e-3f, 1e3f}) {
      for (std::size_t first = 0; first < arrow.size(); ++first) {
        Polygon turned;
        for (std::size_t i = 0; i < arrow.size(); ++i) {
          const Point<Object>& p = arrow[(first + i) % arrow.size()];
          turned.emplace_back(p.x * size, p.y * size, p.z * size);
        }
        const double back = 1 / double(size);
        all.push_back(make_normal_test_mesh(mesh_of(turned),
                                            translate<World>(Vector<World, double>{-1, -1, 0}) *
                                                scale<World, Object>(back, back, back),
                                            exact_newell(turned)));
      }
    }
    return all;
  }();
  return measure_normal_error(engine, meshes, Shading::kFlat, kShownNormal);
}

}  // namespace c23

ExtremeCase c23_reflex_corner() {
  using namespace c23;
  return {
      .id = "C-23",
      .name = "A reflex corner",
      .construction =
          "an arrow head of three sizes, with each of its four corners as the first one",
      .stage = "face normals",
      .right_answer =
          "the normal points to the side of the rational Newell vector, whichever corner comes "
          "first",
      .unit = "normals",
      .oracle = Oracle::kRational,
      .ours = {"newell_vector", [] { return measure_error(newell_in_double); }},
      .naive = {"the cross product of the first three corners",
                [] { return measure_error(naive::first_corner); }},
      .mutants = {{"(V1 - V2) x (V3 - V2)", [] { return measure_error(naive::slide_32); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
