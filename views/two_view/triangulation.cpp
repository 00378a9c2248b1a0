#include "views/two_view/triangulation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

#include "views/two_view/constraint.h"

namespace glassbox::views {

namespace {

using ProjectionMatrix = Eigen::Matrix<double, 3, 4>;

// K R [I | -T], the projection from the left camera's space. For the left camera itself R = I and T
// = 0.
ProjectionMatrix projection_matrix(const Matrix3d& intrinsic, const RelativePose& pose) {
  ProjectionMatrix matrix;
  matrix << pose.rotation, -pose.rotation * pose.translation;
  return intrinsic * matrix;
}

Triangulated in_scene(const Vector4d& homogeneous, const RelativePose& pose, double gap) {
  Triangulated result;
  result.point = homogeneous.w() != 0 ? Vector4d(homogeneous / homogeneous.w()) : homogeneous;
  result.gap = gap;
  const double left = result.point.z();
  const double right =
      pose.rotation.row(2).dot(result.point.head<3>() - result.point.w() * pose.translation);
  result.in_front_of_both = left > 0 && right > 0;
  return result;
}

using Equations = Eigen::Matrix<double, 4, 4>;

Equations equations_of(const Match& seen, const ProjectionMatrix& left,
                       const ProjectionMatrix& right) {
  Equations rows;
  rows << seen.left.x() * left.row(2) - left.row(0), seen.left.y() * left.row(2) - left.row(1),
      seen.right.x() * right.row(2) - right.row(0), seen.right.y() * right.row(2) - right.row(1);
  return rows;
}

// The null vector of the equations. If its last number is below the rounding error of the other
// numbers, the point is at infinity.
Vector4d null_vector(const Equations& rows) {
  const Eigen::JacobiSVD<Equations> svd(rows, Eigen::ComputeFullV);
  Vector4d point = svd.matrixV().col(3);
  constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();
  if (std::abs(point.w()) <= kRounding) {
    point.w() = 0;
    if (point.z() < 0) point = -point;
  }
  return point;
}

Match calibrated(const Match& pixels, const StereoRig& rig) {
  const Rays rays = rays_of(pixels, rig.left_intrinsic, rig.right_intrinsic);
  return {rays.left.head<2>(), rays.right.head<2>()};
}

}  // namespace

Rays rays_of(const Match& pixels, const Matrix3d& left_intrinsic, const Matrix3d& right_intrinsic) {
  return {ray_through(left_intrinsic, pixels.left), ray_through(right_intrinsic, pixels.right)};
}

// For the directions d and e of the two rays in the left camera's space, solves the least squares
// problem t_l d - t_r e = T for t_l and t_r. The determinant of the normal equations is |d x e|^2.
std::optional<ClosestPoints> closest_points(const Rays& rays, const RelativePose& pose) {
  const Vector3d d = rays.left, e = pose.rotation.transpose() * rays.right, t = pose.translation;
  const Vector3d across = d.cross(e);
  const double determinant = across.squaredNorm();
  // 8 u (u: the unit roundoff, 2^-53).
  constexpr double kParallel = 4 * std::numeric_limits<double>::epsilon();
  if (determinant <= kParallel * kParallel * d.squaredNorm() * e.squaredNorm()) return std::nullopt;
  const double along_left = t.cross(e).dot(across) / determinant;
  const double along_right = t.cross(d).dot(across) / determinant;
  const Vector3d on_left = along_left * d, on_right = t + along_right * e;
  return ClosestPoints{along_left * d.norm(), along_right * e.norm(), on_left, on_right,
                       (on_left - on_right).norm()};
}

Triangulated midpoint(const Rays& rays, const RelativePose& pose) {
  const auto closest = closest_points(rays, pose);
  if (!closest) {
    const Vector3d& direction = rays.left;
    return in_scene({direction.x(), direction.y(), direction.z(), 0}, pose, 0);
  }
  const Vector3d middle = (closest->on_left + closest->on_right) / 2;
  return in_scene(middle.homogeneous(), pose, closest->gap);
}

Matrix3d fundamental_of(const StereoRig& rig) {
  return fundamental<double>(essential<double>(rig.pose.rotation, rig.pose.translation),
                             rig.left_intrinsic.inverse(), rig.right_intrinsic.inverse());
}

Triangulated triangulate_linear(const Match& pixels, const StereoRig& rig) {
  const Equations rows = equations_of(pixels, projection_matrix(rig.left_intrinsic, {}),
                                      projection_matrix(rig.right_intrinsic, rig.pose));
  return in_scene(null_vector(rows), rig.pose, 0);
}

Triangulated triangulate_linear_normalised(const Match& pixels, const StereoRig& rig) {
  const Matrix3d identity = Matrix3d::Identity();
  Equations rows = equations_of(calibrated(pixels, rig), projection_matrix(identity, {}),
                                projection_matrix(identity, rig.pose));
  rows.rowwise().normalize();
  return in_scene(null_vector(rows), rig.pose, 0);
}

const char* name_of(Triangulator triangulator) {
  switch (triangulator) {
    case Triangulator::kMidpoint:
      return "midpoint";
    case Triangulator::kLinear:
      return "linear";
    case Triangulator::kLinearNormalised:
      return "linear, normalised";
    case Triangulator::kLindstrom:
      return "Lindstrom";
    case Triangulator::kHartleySturm:
      return "Hartley-Sturm";
  }
  return "";
}

Triangulated triangulate(Triangulator triangulator, const Match& pixels, const StereoRig& rig) {
  const auto meet = [&](const Match& match) {
    return midpoint(rays_of(match, rig.left_intrinsic, rig.right_intrinsic), rig.pose);
  };
  switch (triangulator) {
    case Triangulator::kMidpoint:
      break;
    case Triangulator::kLinear:
      return triangulate_linear(pixels, rig);
    case Triangulator::kLinearNormalised:
      return triangulate_linear_normalised(pixels, rig);
    case Triangulator::kLindstrom:
      return meet(corrected_by_iteration(pixels, fundamental_of(rig)));
    case Triangulator::kHartleySturm:
      return meet(corrected_by_roots(pixels, fundamental_of(rig)));
  }
  return meet(pixels);
}

Matrix3d covariance_of(const Vector3d& point, const StereoRig& rig, double sigma) {
  // The derivatives of the pixel of a point P, K P: the first two rows of K (I - P z^T/Z)/Z, where
  // z is the third axis and Z is the third coordinate of P.
  const auto slopes = [](const Matrix3d& intrinsic, const Vector3d& at) {
    Matrix3d inner = Matrix3d::Identity();
    inner.col(2) -= at / at.z();
    return Eigen::Matrix<double, 2, 3>((intrinsic * inner / at.z()).topRows<2>());
  };
  const Vector3d right = rig.pose.rotation * (point - rig.pose.translation);
  Eigen::Matrix<double, 4, 3> jacobian;
  jacobian << slopes(rig.left_intrinsic, point),
      slopes(rig.right_intrinsic, right) * rig.pose.rotation;
  const Matrix3d information = jacobian.transpose() * jacobian;
  const Eigen::FullPivLU<Matrix3d> lu(information);
  if (!lu.isInvertible()) return Matrix3d::Constant(std::numeric_limits<double>::infinity());
  return sigma * sigma * lu.inverse();
}

double depth_error_of_parallel(double depth, double sigma, double focal_length, double baseline) {
  return depth * depth * std::sqrt(2.0) * sigma / (focal_length * baseline);
}

double reprojection_error(const Vector3d& point, const Match& pixels, const StereoRig& rig) {
  const Vector3d left = rig.left_intrinsic * point;
  const Vector3d right = rig.right_intrinsic * rig.pose.rotation * (point - rig.pose.translation);
  return std::max((left.hnormalized() - pixels.left).norm(),
                  (right.hnormalized() - pixels.right).norm());
}

}  // namespace glassbox::views
