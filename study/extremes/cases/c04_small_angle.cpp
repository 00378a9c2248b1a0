#include <glassbox/base/rounding.h>
#include <glassbox/base/trig.h>
#include <glassbox/pipeline/affine.h>

#include "exact/number.h"
#include "study/extremes/common/camera_types.h"
#include "study/extremes/common/extreme_case.h"
#include "study/naive/camera.h"

namespace glassbox::study {
namespace c04 {

using AngleOf = double (*)(const glm::dmat4&);

Outcome measure_error(AngleOf angle_of) {
  WorstError worst;
  for (const double radians : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7}) {
    for (const WorldVector& axis :
         {WorldVector(0, 0, 1), WorldVector(0, 1, 0), WorldVector(-1, 0, 0)}) {
      const auto r = rotate_degrees<World>(axis, degrees_from_radians(radians));
      if (!r) continue;
      // The exact angle of the rounded matrix: sine and cosine are entries of it.
      const double sine = axis.z != 0 ? r->at(1, 0) : axis.y != 0 ? r->at(0, 2) : -r->at(2, 1);
      const double cosine = axis.z != 0 ? r->at(0, 0) : axis.y != 0 ? r->at(2, 2) : r->at(1, 1);
      const exact::Decimal exact = exact::atan2(exact::Decimal(sine), exact::Decimal(cosine));
      const double error = exact::error_of(angle_of(r->columns), exact) / double(exact);
      worst.add(error, 4 * unit_roundoff<double>, fmt::format("angle {:g}", radians), 1 / radians);
    }
  }
  return worst.outcome();
}

double by_arctangent(const glm::dmat4& r) {
  return axis_angle_of(r).radians;
}
double by_arccosine(const glm::dmat4& r) {
  return naive::arccosine_angle(r);
}
double by_arccosine_in_float(const glm::dmat4& r) {
  return naive::arccosine_angle(glm::mat4(r));
}

}  // namespace c04

ExtremeCase c04_small_angle() {
  using namespace c04;
  return {
      .id = "C-04",
      .name = "The angle of a small rotation",
      .construction =
          "rotations by 0.1 .. 1e-7 rad about the three axes, from whose matrices axis and angle "
          "are computed again",
      .stage = "axis and angle",
      .right_answer =
          "the angle is right to 4 u, because sine and cosine are right to one ulp each, and the "
          "arctangent to 2 (base/trig.h)",
      .unit = "of the angle",
      .oracle = Oracle::kExtended,
      .ours = {"the arctangent of sine over cosine", [] { return measure_error(by_arctangent); }},
      .naive = {"the arccosine of a cosine from the trace, in float",
                [] { return measure_error(by_arccosine_in_float); }},
      .mutants = {{"the arccosine of a cosine from the trace, in double",
                   [] { return measure_error(by_arccosine); }}},
      .not_drawn = "the result is the rotation angle of a matrix, which no picture shows",
  };
}

}  // namespace glassbox::study
