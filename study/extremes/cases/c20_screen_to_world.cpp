#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/divide.h>
#include <glassbox/pipeline/unproject.h>

#include <glm/matrix.hpp>

#include "study/extremes/common/extreme_case.h"

namespace glassbox::study {
namespace c20 {

constexpr double kNear = 0.01, kFar = 1000;

View view_of(DepthRange range) {
  Camera camera;
  camera.lens = PerspectiveLens{1, kNear, kFar};
  return make_view(camera, 1280, 720, range).value();
}

// Transforms a point to depth through the pipeline in float, and computes the distance along the
// gaze back from that depth.
using RoundTrip = double (*)(float distance);

Outcome measure_error(RoundTrip round_trip) {
  WorstError worst;
  for (double z = 0.02; z < 900; z *= 1.21) {
    const float distance = float(z);
    // The bound for reversed depth is 5 u (1 + z/f), as in c10_depth_ratio.cpp (u is the unit
    // roundoff). The distance is computed back in double, whose errors are much smaller.
    const double bound = 5.01 * unit_roundoff<float> * (1 + z / kFar);
    worst.add(std::abs(round_trip(distance) / double(distance) - 1), bound,
              fmt::format("distance {:.4g}", z));
  }
  return worst.outcome();
}

float depth_of(const View& view, float distance) {
  return divide(round_to_float(view.clip_from_eye) * Point<Eye>(0, 0, -distance)).position.z;
}
double distance_by_unproject(DepthRange range, float distance) {
  const View view = view_of(range);
  const auto p = unproject(view, {640, 360, depth_of(view, distance)});
  return p ? -(view.eye_from_world * *p).z : HUGE_VAL;
}
double ours(float distance) {
  return distance_by_unproject(DepthRange::kReversed, distance);
}
double standard_depth(float distance) {
  return distance_by_unproject(DepthRange::kStandard, distance);
}
double by_inverse(DepthRange range, float distance) {
  const View view = view_of(range);
  const glm::mat4 inverse = glm::inverse(glm::mat4(view.clip_from_eye.columns));
  const glm::vec4 p = inverse * glm::vec4(0, 0, depth_of(view, distance), 1);
  return double(-p.z / p.w);
}
double inverse_in_float(float distance) {
  return by_inverse(DepthRange::kStandard, distance);
}

}  // namespace c20

ExtremeCase c20_screen_to_world() {
  using namespace c20;
  return {
      .id = "C-20",
      .name = "From the screen back to the world",
      .construction =
          "near plane 0.01, far plane 1000; distances 0.02 .. 900, each 1.21 times the one before, "
          "are transformed to float depth and back",
      .stage = "unproject",
      .right_answer =
          "the distance is right to 5 u (1 + z/f) with reversed depth; standard depth has the "
          "error u z/n (bound 8)",
      .unit = "of the distance",
      .oracle = Oracle::kAnalytic,
      .ours = {"reversed depth, unproject", [] { return measure_error(ours); }},
      .naive = {"inverse 4x4 matrix in float", [] { return measure_error(inverse_in_float); }},
      .mutants = {{"standard depth", [] { return measure_error(standard_depth); }}},
      .not_drawn = "a picture needs only the transform to the screen; this case tests its inverse",
  };
}

}  // namespace glassbox::study
