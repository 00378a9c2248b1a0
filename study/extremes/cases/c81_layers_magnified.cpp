#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/layers.h"
#include "study/naive/layers.h"

namespace glassbox::study {
namespace c81 {

constexpr int kSide = 64;  // in px

// A wall at a distance of 8 units that fills the picture.
const views::LayeredImage& wall() {
  static const views::LayeredImage image = [] {
    views::LayerBuilder builder(
        layer_camera_of({.width = kSide, .height = kSide, .focal = kSide, .near = 0.5}), 0);
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) builder.add(x, y, 0.5f / 8, color_of_number(1));
    }
    return builder.pack();
  }();
  return image;
}

// Counts the pixels that show nothing; `zoom` is the second camera's focal length divided by the
// first's (F2/F1).
using CountHoles = std::function<int(const views::LayerCamera& to, double zoom)>;

Outcome measure_error(const CountHoles& holes) {
  int most = 0;
  std::string where = "none";
  const auto see = [&](const LayerEye& eye, double zoom, const char* by, int m) {
    const int here = holes(layer_camera_of(eye), zoom);
    if (here <= most) return;
    most = here;
    where =
        fmt::format("{:.1f} % of the pixels are holes when the picture is magnified {} times by {}",
                    100.0 * here / (kSide * kSide), m, by);
  };
  for (const int m : {1, 2, 4}) {
    LayerEye nearer{.width = kSide, .height = kSide, .focal = kSide, .near = 0.5};
    LayerEye zoomed = nearer;
    nearer.at = {0, 0, -8 + 8.0 / m};
    zoomed.focal = kSide * m;
    see(nearer, 1, "moving nearer", m);
    see(zoomed, m, "a longer lens", m);
  }
  return must_be_zero(most, where);
}

int ours(const views::LayerCamera& to, double) {
  return int(
      std::ranges::count(drawn_layers(wall(), to, views::Splat::kProjected).depth.pixels, 0.0f));
}

Outcome measure_side_error(const std::function<double(double zoom, double w)>& side) {
  naive::SplatLoop loop;
  loop.side = side;
  return measure_error([loop](const views::LayerCamera& to, double zoom) {
    return int(std::ranges::count(naive::splat(wall(), to, loop, zoom).depth.pixels, 0.0));
  });
}

}  // namespace c81

ExtremeCase c81_layers_magnified() {
  using namespace c81;
  return {
      .id = "C-81",
      .name = "Layers seen enlarged",
      .construction =
          "64 x 64 samples of a wall, seen 1, 2 and 4 times as large: by an eye that moves nearer, "
          "and by a lens with a longer focal length",
      .stage = "layers",
      .right_answer =
          "there is no hole, because a sample's side is (F2/F1)(d1/d2) (S1-10); with one pixel per "
          "sample, a fraction of 1 - 1/m^2 of the pixels are holes",
      .unit = "pixels",
      .oracle = Oracle::kAnalytic,
      .ours = {"squares of the samples' projected size", [] { return measure_error(ours); }},
      .naive = {"one pixel per sample",
                [] { return measure_side_error([](double, double) { return 1.0; }); }},
      .mutants = {{"3 x 3 pixels per sample, whatever its size",
                   [] { return measure_side_error([](double, double) { return 3.0; }); }},
                  {"the size is computed without the focal lengths",
                   [] {
                     return measure_side_error(
                         [](double, double w) { return std::max(1 / w, 1.0); });
                   }},
                  {"d2/d1 in place of d1/d2",
                   [] {
                     return measure_side_error(
                         [](double zoom, double w) { return std::max(zoom * w, 1.0); });
                   }}},
      .not_drawn = "views/layers warps the samples; no engine of glassbox render takes part",
  };
}

}  // namespace glassbox::study
