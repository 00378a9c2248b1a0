#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/layers.h"
#include "study/naive/layers.h"

namespace glassbox::study {
namespace c86 {

constexpr int kSide = 512;  // in px

// One sample, straight ahead at a distance of 1 unit.
const views::LayeredImage& sample() {
  static const views::LayeredImage image = [] {
    views::LayerBuilder builder(
        layer_camera_of({.width = 1, .height = 1, .focal = 64, .near = 0x1p-24}), 0);
    builder.add(0, 0, 0x1p-24f, {9, 9, 9});
    return builder.pack();
  }();
  return image;
}
// An eye 1/m units in front of the sample: from there the sample is m px wide, starting at the
// middle of the picture.
views::LayerCamera eye_at(double m) {
  return layer_camera_of(
      {.width = kSide, .height = kSide, .focal = 64, .near = 0x1p-24, .at = {0, 0, -1 + 1 / m}});
}

struct Splatted {
  int pixels = 0;    // covered pixels
  int reported = 0;  // samples that are reported as drawn smaller than they are
};
using Draw = std::function<Splatted(double m)>;

// Counts pixels that are drawn too often or missing, and samples for which the report is wrong. The
// samples are 2 to 2^20 px wide.
Outcome measure_error(const Draw& draw) {
  double wrong = 0;
  int silent = 0;
  for (int k = 1; k <= 20; ++k) {
    const double m = std::ldexp(1.0, k), side = std::min(m, double(views::kLargestSplat));
    const Splatted splatted = draw(m);
    wrong += std::abs(splatted.pixels - side * side);
    silent += splatted.reported != (m > side);
  }
  return must_be_zero(
      wrong + silent,
      fmt::format("{} pixels are wrong, and {} samples are reported wrongly", wrong, silent));
}

Splatted ours(double m) {
  const auto picture = drawn_layers(sample(), eye_at(m), views::Splat::kProjected);
  const auto covered = std::ranges::count_if(picture.depth.pixels, [](float z) { return z > 0; });
  return {int(covered), int(picture.counts.oversized)};
}
Splatted by_side(double m, double side, bool reported) {
  naive::SplatLoop loop;
  loop.side = [side](double, double) { return side; };
  const auto picture = naive::splat(sample(), eye_at(m), loop);
  const auto covered = std::ranges::count_if(picture.depth.pixels, [](double z) { return z > 0; });
  return {int(covered), reported ? 1 : 0};
}
Splatted without_limit(double m) {
  return by_side(m, m, false);
}
Splatted in_silence(double m) {
  return by_side(m, std::min(m, double(views::kLargestSplat)), false);
}
Splatted left_out(double m) {
  const bool large = m > views::kLargestSplat;
  return by_side(m, large ? 0 : m, large);
}

}  // namespace c86

ExtremeCase c86_sample_near_eye() {
  using namespace c86;
  return {
      .id = "C-86",
      .name = "A sample very near the eye",
      .construction =
          "one sample at 1/2 to 2^-20 of its first distance, which the size formula makes 2 to "
          "2^20 px wide; and a surface that the first eye sees edge-on, which becomes as large",
      .stage = "layers",
      .right_answer =
          "the sample covers min(m, 64)^2 pixels, and samples that would have been larger are "
          "counted",
      .unit = "pixels and samples",
      .oracle = Oracle::kAnalytic,
      .ours = {"sizes are limited to 64 px, and limited samples are counted",
               [] { return measure_error(ours); }},
      .naive = {"sizes have no limit", [] { return measure_error(without_limit); }},
      .mutants = {{"sizes are limited without a report", [] { return measure_error(in_silence); }},
                  {"samples that are too large are left out",
                   [] { return measure_error(left_out); }}},
      .not_drawn = "views/layers warps the samples; no engine of glassbox render takes part",
  };
}

}  // namespace glassbox::study
