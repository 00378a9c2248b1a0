#include <glassbox/base/counted.h>
#include <glassbox/render/renderer.h>

#include "study/extremes/kit/extreme_case.h"
#include "study/extremes/kit/pair.h"

namespace glassbox::study {
namespace c71 {

PairScene mono() {
  PairScene scene = pair_scene("forest", 0.03);
  scene.pair.half_separation = 0;
  return scene;
}

Outcome judge(const EyePictures& eyes, int passes) {
  const std::uint64_t differ = pixels_that_differ(eyes.left, eyes.right);
  return must_be_zero(double(differ) + passes - 1,
                      fmt::format("{} pixels differ between the eyes, {}", differ,
                                  counted(passes, "pass", "passes")));
}

Outcome judge_engine(EngineKind engine, const PairScene& s = mono()) {
  Renderer renderer(s.scene, Transfer::kSrgb, engine);
  const StereoRendering drawn = renderer.render_pair(s.centre, s.pair, {});
  return judge({drawn.left.color, drawn.right.color}, drawn.passes);
}

Outcome judge_drawn(const Drawer& by) {
  const PairScene s = mono();
  const StereoRendering drawn =
      by.renderer(s.scene, Transfer::kSrgb).render_pair(s.centre, s.pair, {});
  return judge({drawn.left.color, drawn.right.color}, drawn.passes);
}

Outcome judge_ours() {
  return worse_of(judge_engine(EngineKind::kStaged), judge_engine(EngineKind::kTile));
}

// Draws the eyes one after the other, even if the separation is zero.
Outcome judge_two_passes() {
  const PairScene s = mono();
  int passes = 0;
  const auto draw = [&](Side side) {
    ++passes;
    return render_staged(s.scene, eye_view(s.centre, s.pair, side), {}).buffers.color;
  };
  const EyePictures eyes{draw(Side::kLeft), draw(Side::kRight)};
  return judge(eyes, passes);
}

// Uses a minimum separation, as some renderers do.
Outcome judge_least_separation() {
  PairScene s = mono();
  s.pair.half_separation = 1e-3;
  return judge_engine(EngineKind::kTile, s);
}

}  // namespace c71

ExtremeCase c71_zero_separation() {
  using namespace c71;
  return {
      .id = "C-71",
      .name = "No separation",
      .construction = "the forest with both eyes in the middle",
      .stage = "stereo",
      .right = "both pictures are the same to the bit, and drawn in one pass",
      .unit = "pixels, passes too many",
      .oracle = Oracle::kProperty,
      .ours = {"both engines", judge_ours},
      .naive = {"always two passes", judge_two_passes},
      .mutants = {{"a separation of 0.002 in place of none", judge_least_separation}},
      .drawn = judge_drawn,
  };
}

}  // namespace glassbox::study
