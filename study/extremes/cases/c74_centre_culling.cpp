#include <glassbox/pipeline/framing.h>
#include <glassbox/render/renderer.h>

#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/stereo_scene.h"

namespace glassbox::study {
namespace c74 {

Outcome measure_error(StereoCulling culling, EngineKind engine) {
  std::uint64_t lost = 0, triangles = 0, culled = 0, pixels = 0;
  for (const double share : {0.01, 0.03, 0.1}) {
    const StereoScene s = make_stereo_scene("forest", share);
    const EyePictures right = draw_eyes_separately(s);
    Renderer renderer(s.scene, Transfer::kSrgb, engine);
    StereoSettings settings;
    settings.culling = culling;
    const StereoRendering drawn = renderer.render_pair(s.centre, s.pair, settings);
    lost += pixels_that_differ({drawn.left.color, drawn.right.color}, right);
    triangles += drawn.lost;
    culled += drawn.culled;
    pixels += right.left.pixels.size() * 2;
  }
  return must_be_zero(
      double(lost),
      fmt::format("{} of {} pixels are lost, and {} of {} culled triangles are culled wrongly",
                  lost, pixels, triangles, culled));
}

Outcome measure_our_error() {
  return worse_of(measure_error(StereoCulling::kUnion, EngineKind::kStaged),
                  measure_error(StereoCulling::kUnion, EngineKind::kTile));
}

Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<StereoReference> pairs = [] {
    std::vector<StereoReference> made;
    for (const double share : {0.01, 0.03, 0.1}) {
      const StereoScene s = make_stereo_scene("forest", share, 128, 72);
      const Camera camera = s.scene.cameras.empty() ? framing_camera(s.scene, 128.0 / 72).value()
                                                    : s.scene.cameras.front();
      made.emplace_back(make_ray_scene(s.scene, camera, 128, 72), s.pair);
    }
    return made;
  }();
  Outcome worst;
  for (const StereoReference& pair : pairs) worst = worse_of(pair.measure_error(engine), worst);
  return worst;
}

}  // namespace c74

ExtremeCase c74_centre_culling() {
  using namespace c74;
  return {
      .id = "C-74",
      .name = "Culled by the camera in the middle",
      .construction =
          "the scene forest, with half separations of 1, 3 and 10 % of the window's distance",
      .stage = "stereo culling",
      .right_answer =
          "nothing is lost: each eye's picture has the bytes of a run for that eye alone",
      .unit = "pixels",
      .oracle = Oracle::kInteger,
      .ours = {"culling by the union of both frusta, in both engines", measure_our_error},
      .naive = {"culling by the camera in the middle, in the staged engine",
                [] { return measure_error(StereoCulling::kCentre, EngineKind::kStaged); }},
      .mutants = {{"culling by the camera in the middle, in the tile engine",
                   [] { return measure_error(StereoCulling::kCentre, EngineKind::kTile); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
