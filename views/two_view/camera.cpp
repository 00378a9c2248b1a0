#include "views/two_view/camera.h"

#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace glassbox::views {

// Eye space to NDC is x_ndc = (a x + s y + b z)/-z and y_ndc = (c y + d z)/-z, where a, s, b, c and
// d are entries of the projection matrix. The viewport transform follows. With X = x, Y = -y, Z =
// -z, in a viewport of W x H pixels: X_screen = W/2 (a X/Z - s Y/Z) + left + W/2 (1 - b), Y_screen
// = H/2 c Y/Z + top + H/2 (1 + d).
Result<PinholeCamera> camera_of(const View& view) {
  if (!view.perspective) {
    return fail("the camera", "a parallel projection has no centre, and therefore no epipoles",
                "use a perspective camera");
  }
  const auto& clip = view.clip_from_eye;
  const double half_width = double(view.viewport.width()) / 2;
  const double half_height = double(view.viewport.height()) / 2;
  PinholeCamera camera;
  camera.intrinsic << half_width * clip.at(0, 0), -half_width * clip.at(0, 1),
      double(view.viewport.left) + half_width * (1 - clip.at(0, 2)),  //
      0, half_height * clip.at(1, 1), double(view.viewport.top) + half_height * (1 + clip.at(1, 2)),
      0, 0, 1;
  Matrix3d eye_from_world;
  Vector3d shift;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      eye_from_world(row, column) = view.eye_from_world.at(row, column);
    }
    shift[row] = view.eye_from_world.at(row, 3);
  }
  // The camera's centre is the point where x, y and w of clip space are zero. An eye of a stereo
  // pair is beside the origin of eye space (stereo_pair.h).
  const double beside_y = -clip.at(1, 3) / clip.at(1, 1);
  const double beside_x = -(clip.at(0, 3) + clip.at(0, 1) * beside_y) / clip.at(0, 0);
  const Vector3d half_turn(1, -1, -1);
  camera.camera_from_world = half_turn.asDiagonal() * eye_from_world;
  camera.centre = eye_from_world.transpose() * (Vector3d(beside_x, beside_y, 0) - shift);
  return camera;
}

RelativePose relative_pose(const PinholeCamera& left, const PinholeCamera& right) {
  return {right.camera_from_world * left.camera_from_world.transpose(),
          left.camera_from_world * (right.centre - left.centre)};
}

Vector3d project(const PinholeCamera& camera, const Vector3d& world) {
  const Vector3d at = camera.camera_from_world * (world - camera.centre);
  const Vector3d pixel = camera.intrinsic * at;
  return {pixel.x() / pixel.z(), pixel.y() / pixel.z(), at.z()};
}

Vector3d ray_through(const Matrix3d& intrinsic, const Vector2d& pixel) {
  return intrinsic.triangularView<Eigen::Upper>().solve(pixel.homogeneous());
}

}  // namespace glassbox::views
