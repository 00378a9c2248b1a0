#include <glassbox/images/stereo/swapped_eyes.h>
#include <glassbox/render/stereo/disparity.h>

#include "study/extremes/common/coverage.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/stereo_scene.h"

namespace glassbox::study {
namespace c78 {

struct Drawn {
  EyePictures eyes;
  Image<float> disparity;
};

Drawn room_by(const TestedEngine& engine) {
  const StereoScene s = make_stereo_scene("room", 0.03);
  StereoSettings settings;
  settings.render.want_distance = true;
  const StereoRendering pair =
      engine.renderer(s.scene, settings.render.transfer).render_pair(s.centre, s.pair, settings);
  return {{pair.left.color, pair.right.color}, disparity_map(s.centre, s.pair, pair.left.distance)};
}

// The room drawn by the staged reference.
const Drawn& room() {
  static const Drawn drawn = room_by(tested_engines().front());
  return drawn;
}

// The fraction of the windows (small areas of the picture) that vote for exchanged eyes. If it is
// more than a third, the order cannot be decided (images/stereo/swapped_eyes.h).
Outcome outcome_of(const OrderEvidence& evidence) {
  const double votes = double(evidence.in_order + evidence.swapped);
  const char* verdict = evidence.order == EyeOrder::kInOrder   ? "in order"
                        : evidence.order == EyeOrder::kSwapped ? "swapped"
                                                               : "unknown";
  return {votes > 0 ? double(evidence.swapped) / votes : 1,
          1.0 / 3,
          {},
          fmt::format("{}: {} windows fit this order of the eyes, and {} fit the other one",
                      verdict, evidence.in_order, evidence.swapped)};
}

Outcome measure_pair_error(const Image<Rgba8>& left, const Image<Rgba8>& right) {
  return outcome_of(pair_order(left, right, room().disparity).value());
}
Outcome measure_anaglyph_error(const Image<Rgba8>& anaglyph) {
  return outcome_of(anaglyph_order(anaglyph, Glasses::kRedCyan, room().disparity).value());
}

Image<Rgba8> anaglyph(const Image<Rgba8>& left, const Image<Rgba8>& right) {
  return make_anaglyph(left, right, AnaglyphMethod::kMask).value();
}

Image<Rgba8> red_and_blue_interchanged() {
  Image<Rgba8> picture = anaglyph(room().eyes.left, room().eyes.right);
  for (Rgba8& pixel : picture.pixels) std::swap(pixel.r, pixel.b);
  return picture;
}

Outcome measure_drawn_error(const TestedEngine& engine) {
  const Drawn drawn = room_by(engine);
  return outcome_of(pair_order(drawn.eyes.left, drawn.eyes.right, drawn.disparity).value());
}

Outcome measure_our_error() {
  return worse_of(measure_pair_error(room().eyes.left, room().eyes.right),
                  measure_anaglyph_error(anaglyph(room().eyes.left, room().eyes.right)));
}

}  // namespace c78

ExtremeCase c78_eyes_swapped() {
  using namespace c78;
  return {
      .id = "C-78",
      .name = "Left and right pictures exchanged",
      .construction = "the room as a pair and as an anaglyph, with its disparity",
      .stage = "stereo",
      .right_answer =
          "near objects are further left in the right eye's picture: at most a third of the "
          "textured windows fit better with the eyes exchanged",
      .unit = "of the windows",
      .oracle = Oracle::kProperty,
      .ours = {"the pair and the anaglyph as they are drawn", measure_our_error},
      .naive = {"the two pictures are exchanged",
                [] { return measure_pair_error(room().eyes.right, room().eyes.left); }},
      .mutants = {{"the anaglyph's eyes are exchanged",
                   [] {
                     return measure_anaglyph_error(anaglyph(room().eyes.right, room().eyes.left));
                   }},
                  {"red and blue are exchanged, as in BGR files",
                   [] { return measure_anaglyph_error(red_and_blue_interchanged()); }}},
      .drawn = measure_drawn_error,
      .pictures = {{"ours", [] { return png_of(anaglyph(room().eyes.left, room().eyes.right)); }},
                   {"naive", [] { return png_of(anaglyph(room().eyes.right, room().eyes.left)); }}},
  };
}

}  // namespace glassbox::study
