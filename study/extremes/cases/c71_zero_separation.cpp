#include <fmt/format.h>

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
  return {double(differ) + passes - 1,
          0,
          {},
          fmt::format("{} pixels differ between the eyes, {}", differ,
                      counted(passes, "pass", "passes"))};
}

Outcome judge_ours() {
  Outcome worst;
  for (const EngineKind engine : {EngineKind::kStaged, EngineKind::kTile}) {
    const PairScene s = mono();
    Renderer renderer(s.scene, Transfer::kSrgb, engine);
    const StereoRendering drawn = renderer.render_pair(s.centre, s.pair, {});
    const Outcome outcome = judge({drawn.left.color, drawn.right.color}, drawn.passes);
    if (engine == EngineKind::kStaged || outcome.error > worst.error) worst = outcome;
  }
  return worst;
}

// The eyes one after the other, whatever the separation.
Outcome judge_two_passes() {
  return judge(each_eye_alone(mono()), 2);
}

}  // namespace c71

ExtremeCase c71_zero_separation() {
  using namespace c71;
  ExtremeCase c;
  c.id = "C-71";
  c.name = "No separation";
  c.construction = "the forest with both eyes in the middle";
  c.stage = "stereo";
  c.right = "both pictures are the same to the bit, and drawn in one pass";
  c.unit = "pixels, passes too many";
  c.oracle = Oracle::kProperty;
  c.ours = {"both engines", judge_ours};
  c.naive = {"always two passes", judge_two_passes};
  return c;
}

}  // namespace glassbox::study
