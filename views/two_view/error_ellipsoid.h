// The error of a triangulated point that follows from errors of the pixels: its covariance, as an
// ellipsoid.
#pragma once

#include "views/two_view/triangulation.h"

namespace glassbox::views {

// The ellipsoid of one standard deviation about a point. The half axes have the directions of the
// columns of `axes`, which are perpendicular and of length 1, and the lengths `half_axes`, the
// longest first. The covariance is axes diag(half_axes)^2 axes^T. If the pixels do not determine
// the point, all half axes are infinite.
struct ErrorEllipsoid {
  Matrix3d axes = Matrix3d::Identity();
  Vector3d half_axes = Vector3d::Zero();

  Matrix3d covariance() const;
};

// The ellipsoid of a point in front of both cameras that the method has found, if each coordinate
// of both pixels has an independent error of `sigma` pixels. It is correct to first order, so
// sigma has to be small against the parallax in pixels.
//
// To first order every method is a weighted least squares problem: its point minimises the sum of
// |L_k r_k|^2 over both pictures k, where r_k is the difference of the point's pixel and the given
// one. If J has the derivatives of the four pixel coordinates with respect to the point, an error x
// of the pixels moves the point by B x, and the covariance is
//   sigma^2 B B^T with B = (L J)^+ L, where ^+ is the pseudoinverse.
// The weights L_k are
//   optimal             1;        then the covariance is sigma^2 (J^T J)^-1
//   linear              Z_k, the point's depth: x (p_3 P) - p_1 P is Z_k times the residual
//   linear, normalised  Z_k K_k^-1, by rows divided by the norms of the equations
//   midpoint            Z_k (1 - d_k d_k^T) K_k^-1 for the ray's unit direction d_k: the distance
//                       of the point from the ray
// For L = 1 this is the backward propagation of a covariance in Hartley and Zisserman, Multiple
// View Geometry, 5.2.2.
ErrorEllipsoid error_ellipsoid(Triangulator how, const Vector3d& point, const StereoRig& rig,
                               double sigma);

}  // namespace glassbox::views
