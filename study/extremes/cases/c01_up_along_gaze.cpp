#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/look_at.h>

#include "exact/camera.h"
#include "study/extremes/kit/extreme_case.h"
#include "study/extremes/kit/world.h"
#include "study/naive/camera.h"

namespace glassbox::study {
namespace c01 {

Outcome judge(LookAt look_at_under_test) {
  const WorldPoint eye{1, 2, 3};
  const WorldVector gaze{3, -2, 6}, across{6, 3, -2};  // perpendicular, both of length 7
  const WorldPoint target = eye + gaze;
  constexpr double u = unit_roundoff<double>;
  Worst worst;
  for (const double sine : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 2e-6}) {
    const WorldVector up = gaze + across * sine;
    const auto view = look_at_under_test(eye, target, up);
    const exact::Matrix4<exact::Decimal> exact = exact::look_at(eye, target, up);
    // look_at.h: rotation entries within (8 + 4/sine) u. sine of the angle: atan(sine) makes no difference to it.
    const double bound = (8 + 4 / sine) * u;
    const std::string where = fmt::format("up {:g} rad from the gaze", sine);
    if (view) {
      see_entries(worst, *view, exact, 3, bound, where, 1 / sine);
    } else {
      worst.see(1, bound, where, 1 / sine);
    }
  }
  int answered = 0;
  for (const WorldVector& up : {gaze, -gaze, gaze * 1e-30, gaze + across * 1e-7}) {
    const auto view = look_at_under_test(eye, target, up);
    if (!view) continue;
    ++answered;
    worst.see(HUGE_VAL, 0, "a roll was made up where up lies along the gaze");
  }
  return worst.outcome(fmt::format("{} of 4 undefined rolls answered", answered));
}

}  // namespace c01

ExtremeCase c01_up_along_gaze() {
  using namespace c01;
  return {
      .id = "C-01",
      .name = "Up along the gaze",
      .construction =
          "gaze (3, -2, 6), up = gaze + s (6, 3, -2) for s = 0.1 .. 2e-6; then s = 1e-7 and 0",
      .stage = "look-at",
      .right =
          "axes within (8 + 4/sine) u of 50 digits (pipeline/look_at.h); refused where the sine is "
          "below 2^-20",
      .unit = "of the axes' length",
      .oracle = Oracle::kExtended,
      .ours = {"look_at", [] { return judge(look_at); }},
      .naive = {"unchecked UVN", [] { return judge(naive::unchecked_look_at); }},
      .mutants = {{"no limit for the sine", [] { return judge(naive::look_at_without_limit); }},
                  {"V is the given up", [] { return judge(naive::look_at_with_given_up); }},
                  {"in float", [] { return judge(naive::look_at_in_float); }}},
  };
}

}  // namespace glassbox::study
