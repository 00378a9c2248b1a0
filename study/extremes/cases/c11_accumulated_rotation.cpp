#include <glassbox/base/rounding.h>
#include <glassbox/base/trig.h>
#include <glassbox/pipeline/affine.h>

#include "study/extremes/common/camera_types.h"
#include "study/extremes/common/extreme_case.h"

namespace glassbox::study {
namespace c11 {

constexpr int kSteps = 1000000;
constexpr int kBetweenRepairs = 1000;

using Repair = glm::mat3 (*)(const glm::mat3&);

Outcome measure_error(Repair repair) {
  const glm::mat3 step(
      rotate_degrees<World>(WorldVector(1, 2, 3), degrees_from_radians(0.01)).value().columns);
  glm::mat3 turned(1);
  for (int i = 1; i <= kSteps; ++i) {
    turned = step * turned;
    if (i % kBetweenRepairs == 0) turned = repair(turned);
  }
  // The entries are rounded to float after the rotation has been repaired: R^T R has an error of 2
  // * 3 u (u is the unit roundoff of float) for entries of at most 1. The repair itself has an
  // error of 8 u of double.
  return {orthogonality_error(glm::dmat3(turned)), 8.0 * unit_roundoff<float>, std::nullopt,
          fmt::format("after {} products", kSteps)};
}

glm::mat3 nearest(const glm::mat3& r) {
  const auto repaired = nearest_rotation(glm::dmat3(r));
  return repaired ? glm::mat3(repaired->rotation) : r;
}
glm::mat3 nothing(const glm::mat3& r) {
  return r;
}
glm::mat3 unit_columns(const glm::mat3& r) {
  return {glm::normalize(r[0]), glm::normalize(r[1]), glm::normalize(r[2])};
}

}  // namespace c11

ExtremeCase c11_accumulated_rotation() {
  using namespace c11;
  return {
      .id = "C-11",
      .name = "A million rotations",
      .construction = "10^6 float products of a rotation by 0.01 rad about (1, 2, 3)",
      .stage = "rotation",
      .right_answer =
          "R^T R = I to 8 u of float if the matrix is repaired every 1000 products; without a "
          "repair the error grows linearly, by about u/3 per product (B.5)",
      .unit = "entries of R^T R - I",
      .oracle = Oracle::kProperty,
      .ours = {"nearest_rotation after every 1000 products", [] { return measure_error(nearest); }},
      .naive = {"the matrix is never repaired", [] { return measure_error(nothing); }},
      .mutants = {{"only the lengths of the axes are repaired",
                   [] { return measure_error(unit_columns); }}},
      .not_drawn =
          "the products are computed before the renderer gets the camera; make_view refuses a pose "
          "that has drifted as far as the naive one",
  };
}

}  // namespace glassbox::study
