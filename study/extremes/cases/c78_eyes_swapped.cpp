#include <glassbox/images/stereo/order.h>
#include <glassbox/render/stereo/disparity.h>

#include "study/extremes/kit/coverage.h"
#include "study/extremes/kit/extreme_case.h"
#include "study/extremes/kit/pair.h"

namespace glassbox::study {
namespace c78 {

struct Drawn {
  EyePictures eyes;
  Image<float> disparity;
};

Drawn room_by(const Drawer& drawer) {
  const PairScene s = pair_scene("room", 0.03);
  StereoSettings settings;
  settings.render.want_distance = true;
  const StereoRendering pair =
      drawer.renderer(s.scene, settings.render.transfer).render_pair(s.centre, s.pair, settings);
  return {{pair.left.color, pair.right.color}, disparity_map(s.centre, s.pair, pair.left.distance)};
}

// The room drawn by the staged reference.
const Drawn& room() {
  static const Drawn drawn = room_by(drawers().front());
  return drawn;
}

// The share of the windows that vote for exchanged eyes. If it is more than a third, the order
// cannot be decided (images/stereo/order.h).
Outcome outcome_of(const OrderEvidence& evidence) {
  const double votes = double(evidence.in_order + evidence.swapped);
  const char* verdict = evidence.order == EyeOrder::kInOrder   ? "in order"
                        : evidence.order == EyeOrder::kSwapped ? "swapped"
                                                               : "unknown";
  return {votes > 0 ? double(evidence.swapped) / votes : 1,
          1.0 / 3,
          {},
          fmt::format("{}: {} windows for this order, {} against it", verdict, evidence.in_order,
                      evidence.swapped)};
}

Outcome judge_pair(const Image<Rgba8>& left, const Image<Rgba8>& right) {
  return outcome_of(pair_order(left, right, room().disparity).value());
}
Outcome judge_anaglyph(const Image<Rgba8>& anaglyph) {
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

Outcome judge_drawn(const Drawer& by) {
  const Drawn drawn = room_by(by);
  return outcome_of(pair_order(drawn.eyes.left, drawn.eyes.right, drawn.disparity).value());
}

Outcome judge_ours() {
  return worse_of(judge_pair(room().eyes.left, room().eyes.right),
                  judge_anaglyph(anaglyph(room().eyes.left, room().eyes.right)));
}

}  // namespace c78

ExtremeCase c78_eyes_swapped() {
  using namespace c78;
  return {
      .id = "C-78",
      .name = "Left and right pictures exchanged",
      .construction = "the room as a pair and as an anaglyph, with its disparity",
      .stage = "stereo",
      .right =
          "near objects are further left in the right eye's picture: at most a third of the "
          "textured windows fit better with the eyes exchanged",
      .unit = "of the windows",
      .oracle = Oracle::kProperty,
      .ours = {"pair and anaglyph as drawn", judge_ours},
      .naive = {"the pictures exchanged",
                [] { return judge_pair(room().eyes.right, room().eyes.left); }},
      .mutants = {{"the anaglyph's eyes exchanged",
                   [] { return judge_anaglyph(anaglyph(room().eyes.right, room().eyes.left)); }},
                  {"red and blue exchanged, as in BGR files",
                   [] { return judge_anaglyph(red_and_blue_interchanged()); }}},
      .drawn = judge_drawn,
      .pictures = {{"ours", [] { return png_of(anaglyph(room().eyes.left, room().eyes.right)); }},
                   {"naive", [] { return png_of(anaglyph(room().eyes.right, room().eyes.left)); }}},
  };
}

}  // namespace glassbox::study
