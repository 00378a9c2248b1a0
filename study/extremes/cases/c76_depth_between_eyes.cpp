#include <glassbox/images/stereo/anaglyph.h>
#include <glassbox/render/renderer.h>

#include "study/extremes/kit/coverage.h"
#include "study/extremes/kit/extreme_case.h"
#include "study/extremes/kit/pair.h"
#include "study/naive/stereo.h"

namespace glassbox::study {
namespace c76 {

const StereoRendering& eyes() {
  static const StereoRendering drawn = [] {
    const PairScene s = pair_scene("forest", 0.03);
    StereoSettings settings;
    settings.render.want_depth = true;
    return render_pair(s.scene, s.centre, s.pair, settings);
  }();
  return drawn;
}

Image<Rgba8> masked(EngineKind engine) {
  const PairScene s = pair_scene("forest", 0.03);
  Renderer renderer(s.scene, Transfer::kSrgb, engine);
  return renderer.render_masked_anaglyph(s.centre, s.pair, {}, {}).left.color;
}

const Rgba8 kBackground = RenderSettings{}.background;

Image<Rgba8> without_clearing() {
  return naive::anaglyph_without_clearing_depth(eyes().left, eyes().right, kBackground);
}

// Red of the left eye's own picture, green and blue of the right eye's (S0-02).
Outcome judge(const Image<Rgba8>& shown) {
  const Image<Rgba8> right =
      make_anaglyph(eyes().left.color, eyes().right.color, AnaglyphMethod::kMask).value();
  const std::uint64_t differ = pixels_that_differ(shown, right);
  return must_be_zero(double(differ),
                      fmt::format("{} of {} pixels differ", differ, right.pixels.size()));
}

}  // namespace c76

ExtremeCase c76_depth_between_eyes() {
  using namespace c76;
  return {
      .id = "C-76",
      .name = "Depth kept between the eyes",
      .construction =
          "the forest as a red-cyan anaglyph in one colour buffer, window in its middle",
      .stage = "stereo",
      .right = "the channels of the two eyes' own pictures, byte for byte (S0-05)",
      .unit = "pixels",
      .oracle = Oracle::kProperty,
      .ours = {"a depth buffer for each eye, both engines",
               [] {
                 return worse_of(judge(masked(EngineKind::kStaged)),
                                 judge(masked(EngineKind::kTile)));
               }},
      .naive = {"depth not cleared between the eyes", [] { return judge(without_clearing()); }},
      .mutants = {{"colour cleared as well",
                   [] {
                     return judge(naive::anaglyph_with_colour_cleared(eyes().right, kBackground));
                   }},
                  {"the masks are interchanged",
                   [] {
                     return judge(
                         make_anaglyph(eyes().right.color, eyes().left.color, AnaglyphMethod::kMask)
                             .value());
                   }}},
      .pictures = {{"naive", [] { return png_of(without_clearing()); }},
                   {"ours", [] { return png_of(masked(EngineKind::kTile)); }}},
  };
}

}  // namespace glassbox::study
