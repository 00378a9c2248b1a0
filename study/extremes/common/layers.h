// Cameras of layered depth images with simple numbers, and samples that are identified by their
// colour.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "study/experiments/layer_samples.h"
#include "views/layers/draw_layers.h"
#include "views/layers/layer_builder.h"

namespace glassbox::study {

// A perspective camera at a position in the world, looking along -z and turned to the left by an
// angle.
struct LayerEye {
  int width = 0, height = 0;   // in px
  double focal = 1;            // in px; the gaze goes through the middle of the picture
  double near = 1;             // in world units
  std::array<double, 3> at{};  // in world units
  double left_radians = 0;
};

inline views::LayerCamera layer_camera_of(const LayerEye& eye) {
  const double c = std::cos(eye.left_radians), s = std::sin(eye.left_radians);
  Eigen::Matrix4d eye_from_world = Eigen::Matrix4d::Identity();
  eye_from_world.topLeftCorner<3, 3>() << c, 0, -s, 0, 1, 0, s, 0, c;
  const Eigen::Vector3d at(eye.at[0], eye.at[1], eye.at[2]);
  eye_from_world.topRightCorner<3, 1>() = -eye_from_world.topLeftCorner<3, 3>() * at;
  return perspective_camera(eye.width, eye.height, eye.focal, eye.near,
                            Eigen::Isometry3d(eye_from_world));
}

// A colour that encodes the number of a sample. Numbers start at 1; 0 is the background.
inline Rgba8 color_of_number(std::uint32_t n) {
  return {std::uint8_t(n >> 24), std::uint8_t(n >> 16), std::uint8_t(n >> 8), std::uint8_t(n)};
}
inline std::uint32_t number_of_color(const Rgba8& c) {
  return std::uint32_t(c.r) << 24 | std::uint32_t(c.g) << 16 | std::uint32_t(c.b) << 8 | c.a;
}

// The picture by draw_layers: one pixel for each sample, unless `splat` says otherwise.
inline views::LayerPicture drawn_layers(const views::LayeredImage& image,
                                        const views::LayerCamera& to,
                                        views::Splat splat = views::Splat::kPoint,
                                        views::LayerOrder order = views::LayerOrder::kDepth) {
  views::LayerDrawing drawing;
  drawing.splat = splat;
  drawing.order = order;
  drawing.background = {0, 0, 0, 0};
  return views::draw_layers(image, to, drawing);
}

}  // namespace glassbox::study
