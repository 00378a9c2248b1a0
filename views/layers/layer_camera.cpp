#include "views/layers/layer_camera.h"

#include <Eigen/LU>

namespace glassbox::views {

namespace {

// The row of the matrix from eye space to the screen that gives w times the depth (as in
// layer_camera.h).
Eigen::RowVector4d depth_row(const View& view, const Eigen::Matrix4d& clip_from_eye) {
  if (view.perspective) return {0, 0, 0, view.near};
  if (view.depth_range == DepthRange::kReversed) return clip_from_eye.row(2);
  return clip_from_eye.row(3) - clip_from_eye.row(2);
}

}  // namespace

LayerCamera layer_camera(const View& view) {
  const Eigen::Matrix4d clip = matrix_of(view.clip_from_eye);
  const double half_width = double(view.viewport.width()) / 2;
  const double half_height = double(view.viewport.height()) / 2;
  Eigen::Matrix4d screen_from_eye;
  screen_from_eye.row(0) =
      half_width * clip.row(0) + (double(view.viewport.left) + half_width) * clip.row(3);
  screen_from_eye.row(1) =
      -half_height * clip.row(1) + (double(view.viewport.top) + half_height) * clip.row(3);
  screen_from_eye.row(2) = depth_row(view, clip);
  screen_from_eye.row(3) = clip.row(3);
  return {screen_from_eye * matrix_of(view.eye_from_world), int(view.viewport.width()),
          int(view.viewport.height())};
}

double depth_of(const View& view, double distance) {
  const Eigen::Matrix4d clip = matrix_of(view.clip_from_eye);
  const Eigen::Vector4d on_gaze(0, 0, -distance, 1);
  return depth_row(view, clip).dot(on_gaze) / clip.row(3).dot(on_gaze);
}

double distance_of(const View& view, double depth) {
  return view.perspective ? view.near / depth : view.near + (1 - depth) * (view.far - view.near);
}

Eigen::Vector4d eye_of(const LayerCamera& camera) {
  return camera.screen_from_world.inverse().col(2);
}

Eigen::Matrix4d warp_matrix(const LayerCamera& to, const LayerCamera& from) {
  return to.screen_from_world * from.screen_from_world.inverse();
}

}  // namespace glassbox::views
