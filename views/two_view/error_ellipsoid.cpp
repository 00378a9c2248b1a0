#include "views/two_view/error_ellipsoid.h"

#include <limits>

#include <Eigen/SVD>

#include <glassbox/base/elementary.h>

namespace glassbox::views {

namespace {

using Matrix32 = Eigen::Matrix<double, 3, 2>;

// One of the two cameras, with its pose in the left camera's space.
struct SeenBy {
  const Matrix3d& intrinsic;
  RelativePose pose;
  Vector3d at;  // the point in this camera's space
};

// The derivatives of the pixel with respect to the point: the first two rows of
// K (1 - P z^T/Z)/Z R, where z is the third axis and Z is the third coordinate of P.
Eigen::Matrix<double, 2, 3> pixel_slopes(const SeenBy& camera) {
  Matrix3d inner = Matrix3d::Identity();
  inner.col(2) -= camera.at / camera.at.z();
  return (camera.intrinsic * inner / camera.at.z()).topRows<2>() * camera.pose.rotation;
}

// The weights L_k of a picture's residual. Methods with two weights leave the third row 0.
Matrix32 weights_of(Triangulator how, const SeenBy& camera) {
  const double depth = camera.at.z();
  const Matrix3d inverse =
      camera.intrinsic.triangularView<Eigen::Upper>().solve(Matrix3d::Identity());
  const Matrix32 shift = depth * inverse.leftCols<2>();  // of the ray at the point's depth
  Matrix32 weights = Matrix32::Zero();
  switch (how) {
    case Triangulator::kMidpoint: {
      const Vector3d direction = camera.at.normalized();
      return shift - direction * (direction.transpose() * shift);
    }
    case Triangulator::kLinear:
      weights.topRows<2>() = depth * Eigen::Matrix2d::Identity();
      break;
    case Triangulator::kLinearNormalised:
      for (int row = 0; row < 2; ++row) {
        const Vector3d equation =
            camera.at[row] / depth * camera.pose.rotation.row(2) - camera.pose.rotation.row(row);
        const double last = equation.dot(camera.pose.translation);
        weights.row(row) = shift.row(row) / hypotenuse(equation.norm(), last);
      }
      break;
    case Triangulator::kLindstrom:
    case Triangulator::kHartleySturm:
      weights.topRows<2>().setIdentity();
      break;
  }
  return weights;
}

ErrorEllipsoid undetermined(const Matrix3d& axes) {
  return {axes, Vector3d::Constant(std::numeric_limits<double>::infinity())};
}

}  // namespace

Matrix3d ErrorEllipsoid::covariance() const {
  const Matrix3d scaled = axes * half_axes.asDiagonal();
  return scaled * scaled.transpose();
}

// The pseudoinverse comes from singular values, because (J^T J)^-1 would square the condition
// number.
ErrorEllipsoid error_ellipsoid(Triangulator how, const Vector3d& point, const StereoRig& rig,
                               double sigma) {
  const SeenBy cameras[] = {
      {rig.left_intrinsic, {}, point},
      {rig.right_intrinsic, rig.pose, rig.pose.rotation * (point - rig.pose.translation)}};
  Eigen::Matrix<double, 6, 4> weights = Eigen::Matrix<double, 6, 4>::Zero();
  Eigen::Matrix<double, 4, 3> slopes;
  for (int k = 0; k < 2; ++k) {
    weights.block<3, 2>(3 * k, 2 * k) = weights_of(how, cameras[k]);
    slopes.middleRows<2>(2 * k) = pixel_slopes(cameras[k]);
  }
  const Eigen::Matrix<double, 6, 3> weighted = weights * slopes;
  if (!weighted.allFinite()) return undetermined(Matrix3d::Identity());
  const Eigen::JacobiSVD<Eigen::Matrix<double, 6, 3>> svd(
      weighted, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Vector3d values = svd.singularValues();
  // The least singular value has an error of some units of rounding of the greatest.
  constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();
  if (!(values.z() > kRounding * values.x())) {
    return undetermined(svd.matrixV().rowwise().reverse());
  }
  const Eigen::MatrixXd point_slopes = svd.matrixV() * values.cwiseInverse().asDiagonal() *
                                       svd.matrixU().leftCols<3>().transpose() * weights;
  const Eigen::JacobiSVD<Eigen::MatrixXd> spread(point_slopes, Eigen::ComputeThinU);
  return {spread.matrixU(), sigma * spread.singularValues()};
}

}  // namespace glassbox::views
