#include <glassbox/base/rounding.h>
#include <glassbox/mesh/builtin/sphere.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/look_at.h>

#include "exact/camera.h"
#include "study/extremes/common/camera_types.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/ray_cast.h"
#include "study/naive/camera.h"

namespace glassbox::study {
namespace c01 {

Outcome measure_error(LookAt look_at_under_test) {
  const WorldPoint eye{1, 2, 3};
  const WorldVector gaze{3, -2, 6}, across{6, 3, -2};  // perpendicular vectors, both of length 7
  const WorldPoint target = eye + gaze;
  constexpr double u = unit_roundoff<double>;
  WorstError worst;
  for (const double sine : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 2e-6}) {
    const WorldVector up = gaze + across * sine;
    const auto view = look_at_under_test(eye, target, up);
    const exact::Matrix4<exact::Decimal> exact = exact::look_at(eye, target, up);
    // The entries of the rotation are right to (8 + 4/sine) u (u is the unit roundoff), see
    // look_at.h. `sine` is in fact the tangent of the angle, but for such small angles the
    // difference does not matter.
    const double bound = (8 + 4 / sine) * u;
    const std::string where = fmt::format("up {:g} rad from the gaze", sine);
    if (view) {
      add_entry_errors(worst, *view, exact, 3, bound, where, 1 / sine);
    } else {
      worst.add(1, bound, where, 1 / sine);
    }
  }
  int answered = 0;
  for (const WorldVector& up : {gaze, -gaze, gaze * 1e-30, gaze + across * 1e-7}) {
    const auto view = look_at_under_test(eye, target, up);
    if (!view) continue;
    ++answered;
    worst.add(HUGE_VAL, 0, "code computed a roll although up is along the gaze");
  }
  return worst.outcome(
      fmt::format("{} of 4 cameras with an undefined roll were accepted", answered));
}

// A ball seen by a camera whose up vector is nearly parallel to its gaze, compared with camera axes
// that are computed with 50 digits.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<RayCastReference> pictures = [] {
    std::vector<RayCastReference> all;
    Scene ball = make_sphere(6);
    for (Node& node : ball.nodes) {
      node.world_from_node =
          translate<World>(WorldVector{4, 0, 9}) * scale<World>(3, 1, 2) * node.world_from_node;
    }
    for (const double sine : {1e-1, 1e-3, 1e-5, 2e-6}) {
      const WorldVector gaze{3, -2, 6};
      const Aim aim{{1, 2, 3}, WorldPoint{1, 2, 3} + gaze, gaze + WorldVector{6, 3, -2} * sine};
      all.emplace_back(make_ray_scene(ball, aim, PerspectiveLens{1, 0.5, 20.0}, 64));
    }
    return all;
  }();
  return worst_of(pictures, engine);
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
      .right_answer =
          "the axes agree with 50 digits to (8 + 4/sine) u (pipeline/look_at.h); the camera is "
          "refused where the sine is below 2^-20",
      .unit = "of the axes' length",
      .oracle = Oracle::kExtended,
      .ours = {"look_at", [] { return measure_error(look_at); }},
      .naive = {"UVN axes without any check",
                [] { return measure_error(naive::unchecked_look_at); }},
      .mutants = {{"no limit for the sine of the angle between up and gaze",
                   [] { return measure_error(naive::look_at_without_limit); }},
                  {"V is the given up vector, not N x U",
                   [] { return measure_error(naive::look_at_with_given_up); }},
                  {"in float", [] { return measure_error(naive::look_at_in_float); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
