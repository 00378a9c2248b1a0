// Cameras as the geometry of two views speaks of them: x to the right, y down, Z along the gaze; the pixel of a point P of the camera's
// space is K P, up to scale (SPEC S2-10). Eye space (x right, y up, the gaze is -z) is the same, turned half round the x axis.
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

// P_r = R (P_l - T): T is the right camera's centre as the left one sees it (S2-07).
struct RelativePose {
  Matrix3d rotation = Matrix3d::Identity();
  Vector3d translation = Vector3d::Zero();
};

// Of perspective views; a parallel one has no centre, and is an error.
Result<PinholeCamera> camera_of(const View& view);

RelativePose relative_pose(const PinholeCamera& left, const PinholeCamera& right);

// The pixel of a world point; its third number is the distance along the gaze, which is negative behind the camera.
Vector3d project(const PinholeCamera& camera, const Vector3d& world);

// What a pixel looks along, in the camera's space: K^-1 (x, y, 1), of distance 1 along the gaze.
Vector3d ray_through(const Matrix3d& intrinsic, const Vector2d& pixel);

}  // namespace glassbox::views
