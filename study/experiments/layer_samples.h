// Cameras with simple numbers for layered depth images, and samples of random colours (D-14 to
// D-16).
#pragma once

#include <cstdint>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <glassbox/base/random.h>

#include "views/layers/layer_builder.h"

namespace glassbox::study {

// `focal_px` is the focal length in pixels; the gaze goes through the middle of the picture, and
// depth is near/distance.
inline views::LayerCamera perspective_camera(int width, int height, double focal_px, double near,
                                             const Eigen::Isometry3d& eye_from_world) {
  Eigen::Matrix4d screen_from_eye;
  screen_from_eye << focal_px, 0, -width / 2.0, 0,  //
      0, -focal_px, -height / 2.0, 0,               //
      0, 0, 0, near,                                //
      0, 0, -1, 0;
  return {screen_from_eye * eye_from_world.matrix(), width, height};
}

// A random 24-bit colour.
inline Rgba8 random_color(Random& random) {
  const auto channel = [&] { return std::uint8_t(random.integer(0, 255)); };
  const std::uint8_t r = channel(), g = channel(), b = channel();
  return {r, g, b, 255};
}

}  // namespace glassbox::study
