// The camera of a layered depth image: one matrix from the world to the pixels (S1-07).
#pragma once

#include <Eigen/Core>

#include <glassbox/pipeline/view.h>

namespace glassbox::views {

// With (x w, y w, z w, w) = screen_from_world (X, Y, Z, 1): x and y are in pixels from the top
// left, y down; z is the depth, which increases towards the camera: near / distance in a
// perspective view, in (0, 1], and 1 - (distance - near) / (far - near) in a parallel one. This
// depth does not depend on the depth format that a View asks for, and its inverse is well
// conditioned: the distance has the same relative error as the depth (C-37).
struct LayerCamera {
  Eigen::Matrix4d screen_from_world = Eigen::Matrix4d::Identity();
  int width = 0, height = 0;  // in px
};

LayerCamera layer_camera(const View& view);

template <class Target, class Source>
Eigen::Matrix4d matrix_of(const Transform<Target, Source>& transform) {
  Eigen::Matrix4d m;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) m(row, column) = transform.at(row, column);
  }
  return m;
}

// Converts between the distance along a view's direction of view, in world units, and the depth.
double depth_of(const View& view, double distance);
double distance_of(const View& view, double depth);

// The position of the eye in the world, homogeneous. For a parallel view w = 0, and it is the
// direction towards the eye.
Eigen::Vector4d eye_of(const LayerCamera& camera);

// The matrix C12 = C2 C1^-1, where C1 and C2 are screen_from_world of the cameras `from` and `to`,
// in double (S1-07): (x2 w, y2 w, z2 w, w) = C12 (x1, y1, z1, 1), where w is the distance along the
// second camera's direction of view divided by that along the first one's (1 for parallel views).
// It is positive in front of both cameras.
Eigen::Matrix4d warp_matrix(const LayerCamera& to, const LayerCamera& from);

}  // namespace glassbox::views
