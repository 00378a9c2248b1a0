#include <glassbox/pipeline/stereo/constructions.h>
#include <glassbox/pipeline/stereo/parallax.h>

#include "study/extremes/common/attribute.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/stereo_scene.h"

namespace glassbox::study {
namespace c75 {

constexpr StereoPair kPair{0.3, 10};

View centre() {
  return view_from_origin(1920, 1080);
}

using EyeView = View (*)(const View&, const StereoPair&, Side);

// Tests points all over the picture at three distances. If `formula` is true, also compares the
// vertical parallax, counted upwards, with the formula for converging cameras (S0-07).
Outcome measure_error(EyeView eye, bool formula) {
  const View left = eye(centre(), kPair, Side::kLeft), right = eye(centre(), kPair, Side::kRight);
  double worst = 0, off_formula = 0;
  for (const double z : {5.0, 10.0, 40.0}) {
    for (int i = -4; i <= 4; ++i) {
      for (int j = -4; j <= 4; ++j) {
        const Point<Eye, double> p(i * 0.17 * z, j * 0.1 * z, -z);
        const Point<Eye> point(float(p.x), float(p.y), float(p.z));
        // The point is given in the eye space of the centre camera. It must be transformed for each
        // eye, because toe-in rotates eye space.
        const auto y = [&](const View& view) {
          const Point<World> world(point.x, point.y, point.z);
          return double(project(view, round_to_float(view.eye_from_world) * world).position.y);
        };
        const double upwards = y(right) - y(left);
        worst = std::max(worst, std::abs(upwards));
        if (!formula) continue;
        const double said =
            toe_in_vertical_parallax_px(centre(), kPair, {point.x, point.y, point.z});
        off_formula = std::max(off_formula, std::abs(upwards - said));
      }
    }
  }
  if (!formula) return must_be_zero(worst, fmt::format("{} px", worst));
  return must_be_zero(
      worst, fmt::format("{:.3f} px in a corner; the formula agrees within {:.2g} px", worst,
                         off_formula));
}

// Turns only the left eye towards the centre.
View one_toed_in(const View& centre, const StereoPair& pair, Side side) {
  return side == Side::kLeft ? toe_in_view(centre, pair, side) : eye_view(centre, pair, side);
}
// Computes each eye's frustum separately, with separate rounding errors.
View heights_of_their_own(const View& centre, const StereoPair& pair, Side side) {
  View view = eye_view(centre, pair, side);
  if (side == Side::kRight) view.clip_from_eye.at(1, 1) *= 1 + 0x1p-22;
  return view;
}

// Low and wide triangles over the whole picture at three distances. Their edges are almost
// horizontal, so they show if one eye's picture is higher than the other eye's.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const StereoReference steps = [] {
    std::vector<EyeTriangle> triangles;
    const float distances[] = {5, 10, 40};
    for (int row = -12; row < 12; ++row) {
      const float z = distances[(row + 12) % 3], y = float(row) * 0.033f * z;
      triangles.push_back({Point<Eye>{-z, y, -z}, {z, y + 0.002f * z, -z}, {0, y + 0.03f * z, -z}});
    }
    return StereoReference(
        make_ray_scene(triangles, PerspectiveLens{0.785398163397448309616, 0.5, 1000.0}, 160),
        kPair);
  }();
  return steps.measure_error(engine);
}

}  // namespace c75

ExtremeCase c75_toe_in() {
  using namespace c75;
  return {
      .id = "C-75",
      .name = "Cameras turned towards each other",
      .construction =
          "points all over 1920 x 1080 pixels at the distances 5, 10 and 40; window at 10, half of "
          "the separation is 0.3",
      .stage = "stereo",
      .right_answer =
          "there is no vertical parallax, because both eyes' matrices have the same rows of y and "
          "w, so the bits of y are the same",
      .unit = "px",
      .oracle = Oracle::kAnalytic,
      .ours = {"skewed frusta", [] { return measure_error(eye_view, false); }},
      .naive = {"toed-in cameras", [] { return measure_error(toe_in_view, true); }},
      .mutants = {{"only one camera is toed in", [] { return measure_error(one_toed_in, false); }},
                  {"the two matrices' rows of y differ by one or two rounding errors",
                   [] { return measure_error(heights_of_their_own, false); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
