#include <glassbox/pipeline/framing.h>
#include <glassbox/render/renderer.h>

#include "study/extremes/kit/extreme_case.h"
#include "study/extremes/kit/pair.h"

namespace glassbox::study {
namespace c74 {

Outcome judge(StereoCulling culling, EngineKind engine) {
  std::uint64_t lost = 0, triangles = 0, culled = 0, pixels = 0;
  for (const double share : {0.01, 0.03, 0.1}) {
    const PairScene s = pair_scene("forest", share);
    const EyePictures right = each_eye_alone(s);
    Renderer renderer(s.scene, Transfer::kSrgb, engine);
    StereoSettings settings;
    settings.culling = culling;
    const StereoRendering drawn = renderer.render_pair(s.centre, s.pair, settings);
    lost += pixels_that_differ({drawn.left.color, drawn.right.color}, right);
    triangles += drawn.lost;
    culled += drawn.culled;
    pixels += right.left.pixels.size() * 2;
  }
  return must_be_zero(double(lost),
                      fmt::format("{} of {} pixels lost, {} of {} culled triangles wrongly", lost,
                                  pixels, triangles, culled));
}

Outcome judge_ours() {
  return worse_of(judge(StereoCulling::kUnion, EngineKind::kStaged),
                  judge(StereoCulling::kUnion, EngineKind::kTile));
}

Outcome judge_drawn(const Drawer& by) {
  static const std::vector<PairDrawn> pairs = [] {
    std::vector<PairDrawn> made;
    for (const double share : {0.01, 0.03, 0.1}) {
      const PairScene s = pair_scene("forest", share, 128, 72);
      const Camera camera =
          s.scene.cameras.empty() ? frame(s.scene, 128.0 / 72).value() : s.scene.cameras.front();
      made.emplace_back(vista_of(s.scene, camera, 128, 72), s.pair);
    }
    return made;
  }();
  Outcome worst;
  for (const PairDrawn& pair : pairs) worst = worse_of(pair.judge(by), worst);
  return worst;
}

}  // namespace c74

ExtremeCase c74_centre_culling() {
  using namespace c74;
  return {
      .id = "C-74",
      .name = "Culled by the camera in the middle",
      .construction = "the forest, half separations of 1, 3 and 10 % of the window's distance",
      .stage = "stereo culling",
      .right = "nothing is lost: each eye's picture has the bytes of a run for that eye alone",
      .unit = "pixels",
      .oracle = Oracle::kInteger,
      .ours = {"the union of both frusta, both engines", judge_ours},
      .naive = {"centre culling, staged engine",
                [] { return judge(StereoCulling::kCentre, EngineKind::kStaged); }},
      .mutants = {{"centre culling, tile engine",
                   [] { return judge(StereoCulling::kCentre, EngineKind::kTile); }}},
      .drawn = judge_drawn,
  };
}

}  // namespace glassbox::study
