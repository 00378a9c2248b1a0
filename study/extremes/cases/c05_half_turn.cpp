#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/look_at.h>

#include "exact/camera.h"
#include "study/extremes/common/camera_types.h"
#include "study/extremes/common/extreme_case.h"
#include "study/naive/camera.h"

namespace glassbox::study {
namespace c05 {

Outcome measure_error(LookAt look_at_under_test) {
  const WorldPoint eye{0, 0, 0};
  const WorldVector up{0.25, 1, 0};
  WorstError worst;
  for (const double off : {0.0, 1e-200, 1e-17, 1e-12, 1e-9, -1e-9, 1e-6, -1e-6}) {
    const WorldPoint target{off, -2 * off, 1};
    const auto view = look_at_under_test(eye, target, up);
    const exact::Matrix4<exact::Decimal> exact = exact::look_at(eye, target, up);
    // The bound of an entry, in units of the unit roundoff u: 8 for each of the two rotations, 3
    // for their product (gamma_3 of entries below 1), and 17 for the angle of the roll. Its sine
    // and cosine are quotients of entries with an error of 16 u, divided by the length of up in the
    // plane, which is at least 0.97. Together 8 + 8 + 3 + 17 = 36 u.
    const double bound = 36 * unit_roundoff<double>;
    const std::string where = fmt::format("the gaze is {:g} away from straight back", off);
    if (view) {
      add_entry_errors(worst, *view, exact, 3, bound, where);
    } else {
      worst.add(HUGE_VAL, bound, where);
    }
  }
  return worst.outcome();
}

Result<EyeFromWorld> by_the_book(const WorldPoint& eye, const WorldPoint& target,
                                 const WorldVector& up) {
  return naive::axis_angle_view(eye, target, up, {0, 0, -1});
}

// For a gaze straight back, the camera is turned about y, which is right. For a gaze next to it,
// the arccosine is still used.
Result<EyeFromWorld> with_arccosine(const WorldPoint& eye, const WorldPoint& target,
                                    const WorldVector& up) {
  if (target.x == eye.x && target.y == eye.y) return look_at_axis_angle(eye, target, up);
  return by_the_book(eye, target, up);
}

}  // namespace c05

ExtremeCase c05_half_turn() {
  using namespace c05;
  return {
      .id = "C-05",
      .name = "Half a turn about an axis that is not defined",
      .construction =
          "gaze (e, -2e, 1) for e = 0, 1e-200 .. 1e-6 and their negatives, turned to -z by axis "
          "and angle",
      .stage = "look-at",
      .right_answer =
          "the matrix is the UVN matrix of 50 digits, to 36 u; at 180 degrees any axis is right",
      .unit = "of the axes' length",
      .oracle = Oracle::kExtended,
      .ours = {"look_at_axis_angle", [] { return measure_error(look_at_axis_angle); }},
      .naive = {"the axis is v x t over its length, the angle an arccosine",
                [] { return measure_error(by_the_book); }},
      .mutants = {{"the angle is an arccosine", [] { return measure_error(with_arccosine); }}},
      .not_drawn =
          "any axis perpendicular to the two directions is right, so several different pictures "
          "are right",
  };
}

}  // namespace glassbox::study
