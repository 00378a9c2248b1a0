#include <glassbox/base/random.h>

#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/layers.h"
#include "study/naive/layers.h"

namespace glassbox::study {
namespace c83 {

constexpr int kSide = 64;  // in px

// 4,096 samples at distances of 0.5 to 8 units. The second eye has moved 4 units ahead, past many
// of them.
const views::LayeredImage& cloud() {
  static const views::LayeredImage image = [] {
    views::LayerBuilder builder(
        layer_camera_of({.width = kSide, .height = kSide, .focal = 40, .near = 0.25}), 0);
    Random random(83);
    for (std::uint32_t i = 0; i < kSide * kSide; ++i)
      builder.add(int(i % kSide), int(i / kSide), float(0.25 / random.between(0.5, 8)),
                  color_of_number(i + 1));
    return builder.pack();
  }();
  return image;
}
views::LayerCamera passed() {
  return layer_camera_of(
      {.width = kSide, .height = kSide, .focal = 40, .near = 0.25, .at = {0, 0, -4}});
}

Outcome measure_error(const std::function<Image<Rgba8>()>& draw) {
  const Image<Rgba8> drawn = draw();
  const Eigen::Matrix4d warp = views::warp_matrix(passed(), cloud().camera);
  int wrong = 0, missing = 0, shown = 0;
  const auto warped = [&](std::uint32_t number) -> Eigen::Vector4d {
    const int x = int((number - 1) % kSide), y = int((number - 1) / kSide);
    const auto depth = double(cloud().depth[cloud().first[cloud().pixel_index(x, y)]]);
    return warp * Eigen::Vector4d(x + 0.5, y + 0.5, depth, 1);
  };
  for (const Rgba8& pixel : drawn.pixels) {
    const std::uint32_t number = number_of_color(pixel);
    if (number == 0) continue;
    ++shown;
    wrong += !(warped(number).w() > 0);
  }
  // A pixel must not be empty if a sample beyond the near plane is seen in it, unless the sample is
  // too close to the pixel's border.
  for (std::uint32_t number = 1; number <= kSide * kSide; ++number) {
    const Eigen::Vector4d at = warped(number);
    if (!(at.w() > 0) || at.z() / at.w() > 0.999) continue;
    const double x = at.x() / at.w(), y = at.y() / at.w();
    const auto is_well_within = [](double v) {
      return v > 0 && v < kSide && std::abs(v - std::round(v)) > 0x1p-10;
    };
    if (is_well_within(x) && is_well_within(y))
      missing += number_of_color(drawn.at(int(x), int(y))) == 0;
  }
  return wrong_count_outcome(wrong + missing, shown, "pixels are wrong",
                             fmt::format("; {} are missing", missing));
}

Outcome measure_order_error(views::LayerOrder order) {
  return measure_error(
      [order] { return drawn_layers(cloud(), passed(), views::Splat::kPoint, order).color; });
}

Outcome measure_test_error(const std::function<bool(double z, double w)>& is_drawn,
                           const std::function<double(double zoom, double w)>& side) {
  naive::SplatLoop loop;
  loop.is_drawn = is_drawn;
  loop.side = side;
  // Draws without a depth buffer, as in an occlusion-compatible order: a depth buffer happens to
  // hide samples with z < 0.
  loop.compares_depth = false;
  return measure_error([loop] { return naive::splat(cloud(), passed(), loop).color; });
}

}  // namespace c83

ExtremeCase c83_layers_behind() {
  using namespace c83;
  const auto one_pixel = [](double, double) { return 1.0; };
  return {
      .id = "C-83",
      .name = "Samples that the eye has passed",
      .construction =
          "4,096 samples 0.5 to 8 units in front of the first eye, and a second eye 4 units ahead",
      .stage = "layers",
      .right_answer =
          "samples with w <= 0 are not drawn, and all samples beyond the near plane are",
      .unit = "pixels",
      .oracle = Oracle::kProperty,
      .ours = {"samples with w <= 0 are left out",
               [] {
                 return worse_of(measure_order_error(views::LayerOrder::kDepth),
                                 measure_order_error(views::LayerOrder::kOcclusion));
               }},
      .naive = {"positions are divided by w without a test",
                [one_pixel] {
                  return measure_test_error([](double, double) { return true; }, one_pixel);
                }},
      .mutants = {{"only the depth is tested, not w",
                   [one_pixel] {
                     return measure_test_error([](double z, double) { return z <= 1; }, one_pixel);
                   }},
                  {"samples with w >= -1 are drawn",
                   [one_pixel] {
                     return measure_test_error([](double z, double w) { return w >= -1 && z <= 1; },
                                               one_pixel);
                   }},
                  {"samples with a small positive w are left out too",
                   [one_pixel] {
                     return measure_test_error(
                         [](double z, double w) { return w >= 0.2 && z <= 1; }, one_pixel);
                   }}},
      .not_drawn = "views/layers warps the samples; no engine of glassbox render takes part",
  };
}

}  // namespace glassbox::study
