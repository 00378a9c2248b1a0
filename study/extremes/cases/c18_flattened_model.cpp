#include <glassbox/pipeline/affine.h>

#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/normals_case.h"
#include "study/naive/transform.h"

namespace glassbox::study {
namespace c18 {

Outcome measure_error(TransformNormal transform) {
  WorstError worst;
  const auto turn = rotate_degrees<World>(Vector<World, double>(1, 2, 3), 77).value();
  const auto flat = scale<World, Object>(2, 3, 0);
  for (const auto& m : {flat, turn * flat}) {
    for (const Normal<Object>& n : {Normal<Object>(0, 0, 1), Normal<Object>(0.6f, 0, 0.8f),
                                    Normal<Object>(0, -0.8f, -0.6f)}) {
      // The same bound as in c16_squashed_normal.cpp. Even if the model is also turned, rounding
      // leaves the columns of the matrix in a plane, and the exact cofactors belong to that plane.
      worst.add(normal_error(transform(m, n), m, n), 10.0 * unit_roundoff<float>,
                fmt::format("normal ({:g}, {:g}, {:g})", n.x, n.y, n.z));
    }
  }
  // A face that is flattened to a line has no normal; the result must not be NaN.
  const Normal<World> none = transform(flat, {1, 0, 0});
  worst.add(std::isfinite(none.x) && std::isfinite(none.y) && std::isfinite(none.z) ? 0 : HUGE_VAL,
            0, "the face has become a line");
  return worst.outcome();
}

// A triangle in the plane into which the model is flattened, with one of several normals at its
// corners; the last one, (1, 0, 0), becomes zero, so this mesh has no normal.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<NormalTestMesh> meshes = [] {
    std::vector<NormalTestMesh> all;
    const auto turn = rotate_degrees<World>(Vector<World, double>(1, 2, 3), 77).value();
    const auto flat = scale<World, Object>(0.8, 0.7, 0);
    for (const auto& map : {flat, turn * flat}) {
      for (const Normal<Object>& n : {Normal<Object>(0, 0, 1), Normal<Object>(0.6f, 0, 0.8f),
                                      Normal<Object>(0, -0.8f, -0.6f), Normal<Object>(1, 0, 0)}) {
        all.push_back(make_normal_test_mesh(triangle_with_normal(n), map, exact_normal(map, n)));
      }
    }
    return all;
  }();
  // The same bound as in c16_squashed_normal.cpp.
  return measure_normal_error(engine, meshes, Shading::kPhong, 14.0 * unit_roundoff<float>);
}

}  // namespace c18

ExtremeCase c18_flattened_model() {
  using namespace c18;
  return {
      .id = "C-18",
      .name = "A model flattened to a plane",
      .construction = "scale (2, 3, 0), alone and turned by 77 degrees",
      .stage = "normals",
      .right_answer =
          "a face that still has an area has the plane's normal, to 10 u; a face without area has "
          "the zero vector, not NaN",
      .unit = "radian",
      .oracle = Oracle::kRational,
      .ours = {"normal_transform", [] { return measure_error(by_cofactors); }},
      .naive = {"inverse transpose",
                [] { return measure_error(naive::normal_by_inverse_transpose); }},
      .mutants = {{"the normal is multiplied by M itself",
                   [] { return measure_error(naive::normal_by_matrix); }},
                  {"the cofactor matrix is transposed",
                   [] { return measure_error(naive::normal_by_transposed_cofactors); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
