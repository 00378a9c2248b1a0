// Cameras in the convention of two-view geometry: X to the right, Y down, Z along the direction of
// view. The pixel of a point P in the camera's space is K P, up to scale (S2-10). Eye space (x
// right, y up, direction of view -z) is the same space turned by half a turn about the x axis.
#pragma once

#include <Eigen/Core>

#include <glassbox/base/error.h>
#include <glassbox/pipeline/view.h>

namespace glassbox::views {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector4d;

struct PinholeCamera {
  Matrix3d intrinsic = Matrix3d::Identity();          // K: upper triangular, K(2, 2) = 1, in pixels
  Matrix3d camera_from_world = Matrix3d::Identity();  // a rotation
  Vector3d centre = Vector3d::Zero();                 // world units
};

// A point with the coordinates P_l in the left camera's space has P_r = R (P_l - T) in the right
// camera's space. T is the right camera's centre in the left camera's space (S2-07).
struct RelativePose {
  Matrix3d rotation = Matrix3d::Identity();
  Vector3d translation = Vector3d::Zero();
};

// The camera of a perspective view; a parallel view has no centre, so it is an error.
Result<PinholeCamera> camera_of(const View& view);

RelativePose relative_pose(const PinholeCamera& left, const PinholeCamera& right);

// The pixel of a world point; the third number is the distance along the direction of view, which
// is negative behind the camera.
Vector3d project(const PinholeCamera& camera, const Vector3d& world);

// The direction of a pixel's ray in the camera's space: K^-1 (x, y, 1), at distance 1 along the
// direction of view.
Vector3d ray_through(const Matrix3d& intrinsic, const Vector2d& pixel);

}  // namespace glassbox::views
