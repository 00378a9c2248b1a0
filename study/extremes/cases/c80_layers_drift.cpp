#include <Eigen/LU>

#include <glassbox/base/random.h>

#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/layers.h"

namespace glassbox::study {
namespace c80 {

constexpr int kWidth = 8192;

LayerEye first_eye() {
  return {.width = kWidth, .height = 1, .focal = kWidth / 2.0, .near = 0.5};
}
// The second eye is moved and turned in such a way that a row of pixels stays a row.
LayerEye second_eye() {
  LayerEye eye = first_eye();
  eye.at = {0.31, 0, -0.17};
  eye.left_radians = 0.03;
  return eye;
}

// The column of the second picture in which each column's sample is drawn; -1 if it is not visible.
using Columns = std::vector<int>;
using Warp = Columns (*)(const views::LayeredImage&, const views::LayerCamera& to);

const views::LayeredImage& row_of_samples() {
  static const views::LayeredImage row = [] {
    views::LayerBuilder builder(layer_camera_of(first_eye()), 0);
    Random random(80);
    for (int x = 0; x < kWidth; ++x)
      builder.add(x, 0, float(0.5 / random.between(2, 40)), color_of_number(std::uint32_t(x) + 1));
    return builder.pack();
  }();
  return row;
}

Outcome measure_error(Warp warp) {
  const views::LayeredImage& row = row_of_samples();
  const views::LayerCamera to = layer_camera_of(second_eye());
  const Eigen::Matrix4d matrix = views::warp_matrix(to, row.camera);
  const Columns columns = warp(row, to);
  double worst = 0;
  int worst_x = 0, seen = 0;
  for (int x = 0; x < kWidth; ++x) {
    const int column = columns[std::size_t(x)];
    if (column < 0) continue;
    const Eigen::Vector4d at =
        matrix * Eigen::Vector4d(x + 0.5, 0.5, double(row.depth[std::size_t(x)]), 1);
    const double exact = at.x() / at.w();
    // The distance of the exact column from the pixel in which the sample was drawn; the drawn
    // place inside the pixel is unknown.
    const double error = std::max({column - exact, exact - (column + 1), 0.0});
    ++seen;
    if (error > worst) worst = error, worst_x = x;
  }
  if (seen < kWidth / 4) return must_be_zero(HUGE_VAL, fmt::format("only {} samples", seen));
  return {worst,
          1.0 / 16,
          {},
          fmt::format("the largest error is {:.3g} px, at column {}, of {} samples that are seen",
                      worst, worst_x, seen)};
}

Columns ours(const views::LayeredImage& image, const views::LayerCamera& to) {
  const Image<Rgba8> picture = drawn_layers(image, to).color;
  Columns columns(kWidth, -1);
  for (int x = 0; x < kWidth; ++x) {
    const std::uint32_t number = number_of_color(picture.at(x, 0));
    if (number != 0) columns[number - 1] = x;
  }
  return columns;
}

// Computes places by additions in float, which start again from the exact value every `anchor`
// pixels; w starts again every `anchor_w` pixels.
Columns added_up(const views::LayeredImage& image, const views::LayerCamera& to, int anchor,
                 int anchor_w) {
  const Eigen::Matrix4d matrix = views::warp_matrix(to, image.camera);
  const Eigen::Vector4f right = matrix.col(0).cast<float>(), depth = matrix.col(2).cast<float>();
  Eigen::Vector4f start = Eigen::Vector4f::Zero();  // set at the first pixel
  Columns columns;
  for (int x = 0; x < kWidth; ++x, start += right) {
    const Eigen::Vector4d anew = matrix * Eigen::Vector4d(x + 0.5, 0.5, 0, 1);
    if (x % anchor == 0) start.head<3>() = anew.head<3>().cast<float>();
    if (x % anchor_w == 0) start.w() = float(anew.w());
    const Eigen::Vector4f at = start + image.depth[std::size_t(x)] * depth;
    const float column = std::floor(at.x() / at.w());
    columns.push_back(column >= 0 && column < float(kWidth) ? int(column) : -1);
  }
  return columns;
}
Columns never_anew(const views::LayeredImage& image, const views::LayerCamera& to) {
  return added_up(image, to, kWidth, kWidth);
}
Columns seldom_anew(const views::LayeredImage& image, const views::LayerCamera& to) {
  return added_up(image, to, 2048, 2048);
}
Columns without_w(const views::LayeredImage& image, const views::LayerCamera& to) {
  return added_up(image, to, 64, kWidth);
}

}  // namespace c80

ExtremeCase c80_layers_drift() {
  using namespace c80;
  return {
      .id = "C-80",
      .name = "Drift of an incremental warp",
      .construction =
          "a row of 8192 samples, 2 to 40 units away, warped by additions to an eye 0.35 units to "
          "the side and turned by 0.03 radian; the error is the distance of a drawn sample from "
          "its right place",
      .stage = "layers",
      .right_answer =
          "the error is at most 1/16 px: there are 64 additions between two exact starts, each of "
          "which rounds x w and w by at most u, which gives 2 * 64 * 2^-24 * 8192 px",
      .unit = "px",
      .oracle = Oracle::kExtended,
      .ours = {"sums are restarted every 64 px", [] { return measure_error(ours); }},
      .naive = {"sums are started once in each row", [] { return measure_error(never_anew); }},
      .mutants = {{"sums are restarted every 2048 px", [] { return measure_error(seldom_anew); }},
                  {"x and y are restarted every 64 px, but w is not",
                   [] { return measure_error(without_w); }}},
      .not_drawn = "views/layers warps the samples; no engine of glassbox render takes part",
  };
}

}  // namespace glassbox::study
