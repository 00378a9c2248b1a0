#include "views/two_view/located_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include <glassbox/base/elementary.h>
#include <glassbox/base/trig.h>

namespace glassbox::views {

namespace {

constexpr double kUnitRoundoff = std::numeric_limits<double>::epsilon() / 2;

WorldRay world_ray(const PinholeCamera& camera, const Vector3d& direction) {
  return {camera.centre, (camera.camera_from_world.transpose() * direction).normalized()};
}

// The variance of the angle by which errors of a pixel turn its unit direction d towards the unit
// vector `towards`, which is perpendicular to d: d = r/|r| with r = K^-1 (x, y, 1).
double angle_variance(const Matrix3d& intrinsic, const Vector3d& ray, const Vector3d& towards,
                      double sigma) {
  const Matrix3d inverse = intrinsic.triangularView<Eigen::Upper>().solve(Matrix3d::Identity());
  const double slope = (inverse.leftCols<2>().transpose() * towards).norm() / ray.norm();
  return sigma * sigma * slope * slope;
}

// Both directions in the left camera's space, and the standard deviation of their angle. Only
// errors in the plane of both directions change the angle.
double angle_deviation(const Rays& rays, const StereoRig& rig, double sigma) {
  const Vector3d left = rays.left.normalized();
  const Vector3d right = (rig.pose.rotation.transpose() * rays.right).normalized();
  const Vector3d normal = left.cross(right).normalized();
  const Vector3d towards_right = rig.pose.rotation * normal.cross(right);
  return std::sqrt(angle_variance(rig.left_intrinsic, rays.left, normal.cross(left), sigma) +
                   angle_variance(rig.right_intrinsic, rays.right, towards_right, sigma));
}

double angle_of(const Vector3d& a, const Vector3d& b) {
  return arctan2(a.cross(b).norm(), a.dot(b));
}

bool are_parallel(const Vector3d& a, const Vector3d& b) {
  constexpr double kRounding = 64 * kUnitRoundoff;
  return a.cross(b).norm() <= kRounding * a.norm() * b.norm();
}

Vector4d to_world(const Vector4d& point, const PinholeCamera& left) {
  Vector4d world = point;
  world.head<3>() = left.camera_from_world.transpose() * point.head<3>() + point.w() * left.centre;
  return world;
}

PointState state_of(const LocatedPoint& located, const Rays& rays, const StereoRig& rig) {
  const bool is_finite = located.point.allFinite() && std::isfinite(located.angle) &&
                         (!located.closest || std::isfinite(located.closest->gap));
  if (!is_finite) return PointState::kOutOfRange;
  const Vector3d right = rig.pose.rotation.transpose() * rays.right;
  if (are_parallel(rays.left, rig.pose.translation) || are_parallel(right, rig.pose.translation)) {
    return PointState::kOnBaseline;
  }
  if (!located.closest || located.point.w() == 0) return PointState::kAtInfinity;
  constexpr double kDeviations = 3;
  if (located.angle < kDeviations * located.angle_sigma) return PointState::kNearlyParallel;
  const auto& [left_in_front, right_in_front] = located.in_front;
  if (left_in_front && right_in_front) return PointState::kInFront;
  if (right_in_front) return PointState::kBehindLeft;
  return left_in_front ? PointState::kBehindRight : PointState::kBehindBoth;
}

}  // namespace

const char* name_of(PointState state) {
  switch (state) {
    case PointState::kInFront:
      return "in front of both cameras";
    case PointState::kBehindLeft:
      return "behind the left camera";
    case PointState::kBehindRight:
      return "behind the right camera";
    case PointState::kBehindBoth:
      return "behind both cameras";
    case PointState::kNearlyParallel:
      return "rays nearly parallel";
    case PointState::kAtInfinity:
      return "at infinity";
    case PointState::kOnBaseline:
      return "on the baseline";
    case PointState::kOutOfRange:
      return "out of range";
  }
  return "";
}

double LocatedPoint::residual() const {
  return hypotenuse(reprojection_errors[0], reprojection_errors[1]);
}

LocatedPoint locate(Triangulator how, const Match& pixels,
                    const std::array<PinholeCamera, 2>& cameras, double sigma) {
  const auto& [left, right] = cameras;
  const StereoRig rig{left.intrinsic, right.intrinsic, relative_pose(left, right)};
  const Rays rays = rays_of(pixels, left.intrinsic, right.intrinsic);
  const auto closest = closest_points(rays, rig.pose);
  // If the rays are parallel, only their direction is known, whatever the method makes of them.
  const Vector4d point = closest ? triangulate(how, pixels, rig).point
                                 : Vector4d(rays.left.x(), rays.left.y(), rays.left.z(), 0);
  const Vector3d in_left = point.head<3>();
  const Vector3d in_right = rig.pose.rotation * (in_left - point.w() * rig.pose.translation);

  LocatedPoint located;
  located.rays = {world_ray(left, rays.left), world_ray(right, rays.right)};
  located.angle = angle_of(rays.left, rig.pose.rotation.transpose() * rays.right);
  located.closest = closest;
  if (closest) located.angle_sigma = angle_deviation(rays, rig, sigma);
  located.point = to_world(point, left);
  located.in_front = {in_left.z() > 0, in_right.z() > 0};
  const auto error = [](const Matrix3d& intrinsic, const Vector3d& at, const Vector2d& pixel) {
    return at.z() == 0 ? std::numeric_limits<double>::infinity()
                       : ((intrinsic * at).hnormalized() - pixel).norm();
  };
  located.reprojection_errors = {error(left.intrinsic, in_left, pixels.left),
                                 error(right.intrinsic, in_right, pixels.right)};
  located.state = state_of(located, rays, rig);
  if (located.has_place() && in_left.z() != 0 && in_right.z() != 0) {
    ErrorEllipsoid ellipsoid = error_ellipsoid(how, in_left, rig, sigma);
    ellipsoid.axes = (left.camera_from_world.transpose() * ellipsoid.axes).eval();
    located.ellipsoid = ellipsoid;
  }
  return located;
}

bool are_in_one_place(const std::array<PinholeCamera, 2>& cameras) {
  const Vector3d &a = cameras[0].centre, &b = cameras[1].centre;
  return (b - a).norm() <= 32 * kUnitRoundoff * (a.norm() + b.norm());
}

}  // namespace glassbox::views
