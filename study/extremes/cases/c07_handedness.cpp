#include <glassbox/base/trig.h>
#include <glassbox/pipeline/clip.h>
#include <glassbox/pipeline/projection.h>

#include <glassbox/base/random.h>
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/ray_cast.h"

namespace glassbox::study {
namespace c07 {

using Lens = Transform<Clip, Eye> (*)();

Outcome measure_error(Lens lens) {
  // The projection matrix of the slides, T_pers with h = d = 1, maps a point in front of the eye to
  // (x/depth, y/depth).
  const Transform<Clip, Eye, float> m = round_to_float(lens());
  const auto planes = frustum_planes();
  Random random(707);
  int wrong = 0, w_positive = 0;
  constexpr int kPoints = 1000;
  for (int i = 0; i < kPoints; ++i) {
    const double depth = random.between(1.01, 9.99);
    const double x = random.between(-0.9, 0.9), y = random.between(-0.9, 0.9);
    const Point<Clip> front = m * Point<Eye>(float(x * depth), float(y * depth), float(-depth));
    const Point<Clip> behind = m * Point<Eye>(float(x * depth), float(y * depth), float(depth));
    w_positive += front.w > 0;
    // The point in front must be visible, the one behind must not, and the image must be on the
    // right side.
    const bool seen = clip_point(front, planes) && !clip_point(behind, planes);
    wrong += !seen || (front.x > 0) != (x > 0) || (front.y > 0) != (y > 0);
  }
  return wrong_count_outcome(wrong, kPoints, "points are wrong",
                             fmt::format("; {} points in front of the eye have w > 0", w_positive));
}

Transform<Clip, EyeLeft> t_pers_1_10() {
  return t_pers(1, 1, 10).value();
}
Transform<Clip, Eye> with_adaptor() {
  return t_pers_1_10() * eye_left_from_eye();
}
Transform<Clip, Eye> without_adaptor() {
  return Transform<Clip, Eye>(t_pers_1_10().columns);
}
Transform<Clip, Eye> turned_round() {
  Transform<EyeLeft, Eye> half_turn;
  half_turn.at(0, 0) = half_turn.at(2, 2) = -1;
  return t_pers_1_10() * half_turn;
}
Transform<Clip, Eye> w_negated() {
  Transform<Clip, Eye> m = without_adaptor();
  for (int column = 0; column < 4; ++column) m.at(3, column) = -m.at(3, column);
  return m;
}

// 60 small triangles in front of the eye, and their reflections behind it.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const RayCastReference picture([] {
    Random random(807);
    std::vector<EyeTriangle> triangles;
    for (int i = 0; i < 60; ++i) {
      const double depth = random.between(1.5, 9.5);
      const double x = random.between(-0.9, 0.9) * depth, y = random.between(-0.9, 0.9) * depth;
      EyeTriangle front, behind;
      for (std::size_t k = 0; k < 3; ++k) {
        const double dx = random.between(-0.2, 0.2) * depth, dy = random.between(-0.2, 0.2) * depth;
        const double dz = random.between(-0.4, 0.4);
        front[k] = {float(x + dx), float(y + dy), float(-depth + dz)};
        behind[k] = {front[k].x, front[k].y, -front[k].z};
      }
      triangles.push_back(front);
      triangles.push_back(behind);
    }
    return make_ray_scene(triangles, PerspectiveLens{radians_from_degrees(90), 1, 10.0}, 96);
  }());
  return picture.measure_error(engine);
}

}  // namespace c07

ExtremeCase c07_handedness() {
  using namespace c07;
  return {
      .id = "C-07",
      .name = "Handedness mixed",
      .construction =
          "a right-handed view matrix (S4.5) and the left-handed projection T_pers of S4.18; 1000 "
          "points in front of the eye and their reflections behind it",
      .stage = "projection",
      .right_answer =
          "points in front of the eye are seen, on their side of the picture, and points behind it "
          "are not (erratum E12)",
      .unit = "points",
      .oracle = Oracle::kProperty,
      .ours = {"T_pers times the reflection diag(1, 1, -1, 1)",
               [] { return measure_error(with_adaptor); }},
      .naive = {"T_pers without a reflection", [] { return measure_error(without_adaptor); }},
      .mutants = {{"half a turn about y instead of the reflection",
                   [] { return measure_error(turned_round); }},
                  {"only the sign of w is changed", [] { return measure_error(w_negated); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
