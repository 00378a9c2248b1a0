#include <glassbox/pipeline/affine.h>

#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/normals_case.h"
#include "study/naive/transform.h"

namespace glassbox::study {
namespace c16 {

Outcome measure_error(TransformNormal transform) {
  WorstError worst;
  for (const double squash : {0.5, 1e-2, 1e-4, 1e-6}) {
    const auto upright = scale<World, Object>(1, 1, squash);
    const auto sheared = shear<World>(Axis::kX, Axis::kY, 0.75) * upright;
    for (const auto& m : {upright, sheared}) {
      for (const Normal<Object>& n : {Normal<Object>(0.6f, 0, 0.8f), Normal<Object>(0, 1, 0),
                                      Normal<Object>(0, -0.8f, 0.6f)}) {
        // The entries are rounded to float; then there are three products, two sums of two terms of
        // the same size, and the components of the unit vector. 10 u (u is the unit roundoff of
        // float) covers all these rounding errors (C-16).
        worst.add(normal_error(transform(m, n), m, n), 10.0 * unit_roundoff<float>,
                  fmt::format("scale (1, 1, {:g})", squash));
      }
    }
  }
  return worst.outcome();
}

// Triangles in the plane that is not squashed, with the same normals as in measure_error at their
// corners.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<NormalTestMesh> meshes = [] {
    std::vector<NormalTestMesh> all;
    for (const double squash : {0.5, 1e-2, 1e-4, 1e-6}) {
      const auto upright = scale<World, Object>(1, 1, squash);
      for (const auto& map : {upright, shear<World>(Axis::kX, Axis::kY, 0.75) * upright,
                              scale<World>(-1, 1, 1) * upright}) {
        for (const Normal<Object>& n : {Normal<Object>(0.6f, 0, 0.8f), Normal<Object>(0, 1, 0),
                                        Normal<Object>(0, -0.8f, 0.6f)}) {
          all.push_back(make_normal_test_mesh(triangle_with_normal(n), map, exact_normal(map, n)));
        }
      }
    }
    return all;
  }();
  // The bound is 10 u for the normal, plus 4 u for the interpolation of three equal normals.
  return measure_normal_error(engine, meshes, Shading::kPhong, 14.0 * unit_roundoff<float>);
}

}  // namespace c16

ExtremeCase c16_squashed_normal() {
  using namespace c16;
  return {
      .id = "C-16",
      .name = "Normals under non-uniform scale",
      .construction = "scale (1, 1, s) for s = 0.5 .. 1e-6, alone and sheared, on three normals",
      .stage = "normals",
      .right_answer =
          "the normal has the direction of the exact cofactor matrix times the normal, to 10 u",
      .unit = "radian",
      .oracle = Oracle::kRational,
      .ours = {"normal_transform", [] { return measure_error(by_cofactors); }},
      .naive = {"the normal is multiplied by M itself",
                [] { return measure_error(naive::normal_by_matrix); }},
      .mutants = {{"the cofactor matrix is transposed",
                   [] { return measure_error(naive::normal_by_transposed_cofactors); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
