#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/view.h>

#include <glassbox/base/random.h>
#include "study/extremes/common/camera_types.h"
#include "study/extremes/common/extreme_case.h"

namespace glassbox::study {
namespace c12 {

// Computes the view from a pose as it is stored in a file.
using ViewOf = EyeFromWorld (*)(const Transform<World, Eye>& pose);

Outcome measure_error(ViewOf view_of) {
  Random random(712);
  double moved = 0;
  WorstError worst;
  for (int i = 0; i < 200; ++i) {
    const Vector<Eye, double> axis{random.between(-1, 1), random.between(-1, 1),
                                   random.between(0.1, 1)};
    const auto exact = rotate_degrees<World, Eye>(axis, random.between(0, 360)).value();
    auto printed = exact;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        printed.at(row, column) = std::round(exact.at(row, column) * 1e6) / 1e6;
      }
    }
    const EyeFromWorld view = view_of(printed);
    // The nearest rotation is orthogonal to 8 u (u is the unit roundoff); the test for this adds
    // three products and their sums, of entries of at most 1.
    worst.add(orthogonality_error(glm::dmat3(view.columns)), 12 * unit_roundoff<double>,
              fmt::format("rotation {}", i));
    // A point that is seen at the corner of a picture of 640 x 480 px with a focal length of 1000
    // px.
    const Point<World, double> p = exact * Point<Eye, double>(0.32, 0.24, -1);
    const Point<Eye, double> q = view * p;
    moved =
        std::max({moved, 1000 * std::abs(q.x / -q.z - 0.32), 1000 * std::abs(q.y / -q.z - 0.24)});
  }
  // Rounding to six digits changes each entry by at most 5e-7, and making the matrix a rotation
  // again changes it by as much. Three entries move the point by up to 1000 px * 3 * 1e-6, and the
  // divide at most doubles that.
  if (!(moved <= 1000 * 3 * 1e-6 * 2)) worst.add(HUGE_VAL, 0, "the picture moves");
  return worst.outcome(fmt::format("the picture moves by up to {:.1e} px", moved));
}

EyeFromWorld ours(const Transform<World, Eye>& pose) {
  Camera camera;
  camera.world_from_eye = pose;
  return make_view(camera, 640, 480).value().eye_from_world;
}
EyeFromWorld taken_for_rigid(const Transform<World, Eye>& pose) {
  return inverse_rigid(pose);
}
EyeFromWorld unit_columns(const Transform<World, Eye>& pose) {
  auto repaired = pose;
  for (int k = 0; k < 3; ++k) {
    repaired.columns[k] = glm::dvec4(glm::normalize(glm::dvec3(pose.columns[k])), 0);
  }
  return inverse_rigid(repaired);
}

}  // namespace c12

ExtremeCase c12_few_digits() {
  using namespace c12;
  return {
      .id = "C-12",
      .name = "A rotation with few digits",
      .construction =
          "200 poses whose rotations are printed with six decimals, as data files have them",
      .stage = "view",
      .right_answer =
          "the view's axes are perpendicular unit vectors to 12 u, and points of the picture move "
          "by less than 6e-3 px",
      .unit = "entries of R^T R - I",
      .oracle = Oracle::kProperty,
      .ours = {"make_view", [] { return measure_error(ours); }},
      .naive = {"the printed matrix is used without a repair",
                [] { return measure_error(taken_for_rigid); }},
      .mutants = {{"only the lengths of the axes are repaired",
                   [] { return measure_error(unit_columns); }}},
      .not_drawn =
          "the few digits move points of a picture of 16384 px by less than the snap to 1/256 px "
          "does",
  };
}

}  // namespace glassbox::study
