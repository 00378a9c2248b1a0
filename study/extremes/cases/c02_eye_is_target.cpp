#include <glassbox/pipeline/look_at.h>

#include "study/extremes/common/camera_types.h"
#include "study/extremes/common/extreme_case.h"
#include "study/naive/camera.h"

namespace glassbox::study {
namespace c02 {

Outcome measure_error(LookAt look_at_under_test) {
  int answered = 0, all = 0;
  for (const WorldPoint& eye :
       {WorldPoint(0, 0, 0), WorldPoint(1, 2, 3), WorldPoint(1e300, 0, -1e-300)}) {
    answered += bool(look_at_under_test(eye, eye, {0, 1, 0}));
    // Eye and target differ, but by less than the smallest normalised double: the direction would
    // depend on how the processor treats subnormal numbers.
    answered += bool(look_at_under_test({0, 0, 0}, {0, 0, 0x1p-1070}, {0, 1, 0}));
    all += 2;
  }
  // One ulp of distance between eye and target is enough to give a direction.
  const auto near = look_at_under_test({1, 2, 3}, {1, 2, 3 - 0x1p-51}, {0, 1, 0});
  answered += !near || *near != *look_at({1, 2, 3}, {1, 2, 2}, {0, 1, 0});
  return wrong_count_outcome(answered, all + 1, "cameras get a wrong answer");
}

// The code that beginners write: it rejects an eye that is the target, but accepts subnormal
// distances between them.
Result<EyeFromWorld> equality_alone(const WorldPoint& eye, const WorldPoint& target,
                                    const WorldVector& up) {
  if (eye == target) return fail("eye", "is the target", "move one of them");
  return naive::unchecked_look_at(eye, target, up);
}
// Rejects a distance of less than a millionth as too small, whatever the unit of length is.
Result<EyeFromWorld> least_distance(const WorldPoint& eye, const WorldPoint& target,
                                    const WorldVector& up) {
  if (!(length(target - eye) > 1e-6)) return fail("eye", "is the target", "move one of them");
  return look_at(eye, target, up);
}

}  // namespace c02

ExtremeCase c02_eye_is_target() {
  using namespace c02;
  return {
      .id = "C-02",
      .name = "The eye is the target",
      .construction =
          "the eye is the target, at three places; the eye is 2^-1070 from the target; it is one "
          "ulp from the target",
      .stage = "look-at",
      .right_answer =
          "there is an error and no matrix; but a distance of one ulp gives a direction like any "
          "other",
      .unit = "cameras",
      .oracle = Oracle::kProperty,
      .ours = {"look_at", [] { return measure_error(look_at); }},
      .naive = {"UVN axes without any check",
                [] { return measure_error(naive::unchecked_look_at); }},
      .mutants = {{"only an eye exactly equal to the target is refused",
                   [] { return measure_error(equality_alone); }},
                  {"all eyes nearer than 1e-6 to the target are refused",
                   [] { return measure_error(least_distance); }}},
      .not_drawn = "two equal points are refused, so there is no camera to draw with",
  };
}

}  // namespace glassbox::study
