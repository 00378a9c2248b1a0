#include <glassbox/images/stereo/anaglyph.h>
#include <glassbox/render/renderer.h>

#include "study/extremes/common/coverage.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/stereo_scene.h"
#include "study/naive/stereo.h"

namespace glassbox::study {
namespace c76 {

const StereoRendering& eyes() {
  static const StereoRendering drawn = [] {
    const StereoScene s = make_stereo_scene("forest", 0.03);
    StereoSettings settings;
    settings.render.want_depth = true;
    return render_pair(s.scene, s.centre, s.pair, settings);
  }();
  return drawn;
}

Image<Rgba8> masked(EngineKind engine) {
  const StereoScene s = make_stereo_scene("forest", 0.03);
  Renderer renderer(s.scene, Transfer::kSrgb, engine);
  return renderer.render_masked_anaglyph(s.centre, s.pair, {}, {}).left.color;
}

const Rgba8 kBackground = RenderSettings{}.background;

Image<Rgba8> without_clearing() {
  return naive::anaglyph_without_clearing_depth(eyes().left, eyes().right, kBackground);
}

// Expects the red of the left eye's own picture, and the green and blue of the right eye's (S0-02).
Outcome measure_error(const Image<Rgba8>& shown) {
  const Image<Rgba8> right =
      make_anaglyph(eyes().left.color, eyes().right.color, AnaglyphMethod::kMask).value();
  const std::uint64_t differ = pixels_that_differ(shown, right);
  return must_be_zero(double(differ),
                      fmt::format("{} of {} pixels differ", differ, right.pixels.size()));
}

// Cards one in front of the other, where each texel has a colour of its own: the red channel must
// show what the left eye sees, green and blue what the right eye sees.
RayScene cards() {
  std::vector<EyeTriangle> triangles;
  std::vector<Texcoords> texcoords;
  for (int i = 0; i < 6; ++i) {
    const float z = -12 + 1.7f * float(i), x = float(i % 3 - 1) * 1.3f, y = float(i / 3) - 0.7f;
    triangles.push_back(
        {Point<Eye>{x - 1.5f, y - 1.2f, z}, {x + 1.5f, y - 1.2f, z}, {x, y + 1.6f, z}});
    texcoords.push_back({{{0, 0}, {1, 0}, {0.5f, 1}}});
  }
  return textured_ray_scene(triangles, texcoords, PerspectiveLens{0.7, 1, 20.0}, 96, {32, 32},
                            Wrap::kClampToEdge);
}

Outcome measure_drawn_error(const TestedEngine& engine) {
  constexpr StereoPair kPair{0.2, 8};
  static const RayCastReference left(eye_ray_scene(cards(), kPair, Side::kLeft)),
      right(eye_ray_scene(cards(), kPair, Side::kRight));
  const RayScene& centre = left.ray_scene();
  StereoSettings settings;
  settings.render = centre.settings;
  settings.render.want_id = false;
  const Image<Rgba8> shown = engine.renderer(centre.scene, settings.render.transfer)
                                 .render_masked_anaglyph(centre.view, kPair, settings, {})
                                 .left.color;
  const auto color = [&](const RayHits& hits) {
    return hits.nearest == 0 ? settings.render.background
                             : color_of_texel(hits.texel[0], hits.texel[1]);
  };
  std::size_t judged = 0, wrong = 0;
  for (std::size_t i = 0; i < shown.pixels.size(); ++i) {
    const auto in_left = left.hits(i), in_right = right.hits(i);
    if (!in_left || !in_right) continue;
    ++judged;
    const Rgba8 &found = shown.pixels[i], a = color(*in_left), b = color(*in_right);
    wrong += found.r != a.r || found.g != b.g || found.b != b.b;
  }
  Outcome outcome = must_be_zero(
      double(wrong), fmt::format("{} of {} pixels have a wrong channel", wrong, judged));
  if (2 * judged < shown.pixels.size()) outcome.error = HUGE_VAL;
  return outcome;
}

}  // namespace c76

ExtremeCase c76_depth_between_eyes() {
  using namespace c76;
  return {
      .id = "C-76",
      .name = "Depth kept between the eyes",
      .construction =
          "the scene forest as a red-cyan anaglyph in one colour buffer, with the window in the "
          "middle of the trees",
      .stage = "stereo",
      .right_answer = "each channel is that of the picture of its eye, byte for byte (S0-05)",
      .unit = "pixels",
      .oracle = Oracle::kProperty,
      .ours = {"a depth buffer for each eye, both engines",
               [] {
                 return worse_of(measure_error(masked(EngineKind::kStaged)),
                                 measure_error(masked(EngineKind::kTile)));
               }},
      .naive = {"depth is not cleared between the eyes",
                [] { return measure_error(without_clearing()); }},
      .mutants = {{"colour is cleared between the eyes as well",
                   [] {
                     return measure_error(
                         naive::anaglyph_with_colour_cleared(eyes().right, kBackground));
                   }},
                  {"the colour masks of the eyes are exchanged",
                   [] {
                     return measure_error(
                         make_anaglyph(eyes().right.color, eyes().left.color, AnaglyphMethod::kMask)
                             .value());
                   }}},
      .drawn = measure_drawn_error,
      .pictures = {{"naive", [] { return png_of(without_clearing()); }},
                   {"ours", [] { return png_of(masked(EngineKind::kTile)); }}},
  };
}

}  // namespace glassbox::study
