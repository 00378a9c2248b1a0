#include <glassbox/base/counted.h>
#include <glassbox/render/renderer.h>

#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/stereo_scene.h"

namespace glassbox::study {
namespace c71 {

StereoScene mono() {
  StereoScene scene = make_stereo_scene("forest", 0.03);
  scene.pair.half_separation = 0;
  return scene;
}

Outcome measure_error(const EyePictures& eyes, int passes) {
  const std::uint64_t differ = pixels_that_differ(eyes.left, eyes.right);
  return must_be_zero(double(differ) + passes - 1,
                      fmt::format("{} pixels differ between the eyes, {}", differ,
                                  counted(passes, "pass", "passes")));
}

Outcome measure_engine_error(EngineKind engine, const StereoScene& s = mono()) {
  Renderer renderer(s.scene, Transfer::kSrgb, engine);
  const StereoRendering drawn = renderer.render_pair(s.centre, s.pair, {});
  return measure_error({drawn.left.color, drawn.right.color}, drawn.passes);
}

Outcome measure_drawn_error(const TestedEngine& engine) {
  const StereoScene s = mono();
  const StereoRendering drawn =
      engine.renderer(s.scene, Transfer::kSrgb).render_pair(s.centre, s.pair, {});
  return measure_error({drawn.left.color, drawn.right.color}, drawn.passes);
}

Outcome measure_our_error() {
  return worse_of(measure_engine_error(EngineKind::kStaged),
                  measure_engine_error(EngineKind::kTile));
}

// Draws the eyes one after the other, even if the separation is zero.
Outcome measure_two_pass_error() {
  const StereoScene s = mono();
  int passes = 0;
  const auto draw = [&](Side side) {
    ++passes;
    return render_staged(s.scene, eye_view(s.centre, s.pair, side), {}).buffers.color;
  };
  const EyePictures eyes{draw(Side::kLeft), draw(Side::kRight)};
  return measure_error(eyes, passes);
}

// Uses a minimum separation, as some renderers do.
Outcome measure_least_separation_error() {
  StereoScene s = mono();
  s.pair.half_separation = 1e-3;
  return measure_engine_error(EngineKind::kTile, s);
}

}  // namespace c71

ExtremeCase c71_zero_separation() {
  using namespace c71;
  return {
      .id = "C-71",
      .name = "No separation",
      .construction = "the scene forest with both eyes in the middle",
      .stage = "stereo",
      .right_answer = "both pictures are the same to the bit, and drawn in one pass",
      .unit = "pixels, and passes too many",
      .oracle = Oracle::kProperty,
      .ours = {"both engines", measure_our_error},
      .naive = {"always two passes", measure_two_pass_error},
      .mutants = {{"a separation of 0.002 in place of 0", measure_least_separation_error}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
