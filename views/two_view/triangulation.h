// Triangulation: finds the point that two pictures show (S2-05, D-23). Points are in the left
// camera's space.
#pragma once

#include <optional>

#include "views/two_view/camera.h"
#include "views/two_view/match.h"

namespace glassbox::views {

// The directions of the two pixels' rays, each in its own camera's space, with the third coordinate
// 1 (along the direction of view).
struct Rays {
  Vector3d left, right;
};
Rays rays_of(const Match& pixels, const Matrix3d& left_intrinsic, const Matrix3d& right_intrinsic);

// Where two rays are closest to each other, in the left camera's space: at t_l d_l and T + t_r R^T
// d_r for directions of length 1. The distances t_l and t_r are negative behind a camera.
struct ClosestPoints {
  double along_left = 0, along_right = 0;  // t_l and t_r
  Vector3d on_left = Vector3d::Zero(), on_right = Vector3d::Zero();
  double gap = 0;  // the distance between them
};

// None if the rays are parallel to within the rounding of their directions (8 u, where u = 2^-53 is
// the unit roundoff).
std::optional<ClosestPoints> closest_points(const Rays& rays, const RelativePose& pose);

// A triangulated point. Parallel rays meet at infinity (C-107): then the last number is 0, and the
// first three are the direction.
struct Triangulated {
  Vector4d point = Vector4d::Zero();  // homogeneous; (X, Y, Z, 1) if it is finite
  double gap = 0;                     // smallest distance between the rays; 0 at infinity
  bool in_front_of_both = false;

  bool is_finite() const { return point.w() != 0; }
};

// The slides' midpoint method: the middle of the shortest segment between the rays. It is at
// infinity if closest_points() takes the rays for parallel.
Triangulated midpoint(const Rays& rays, const RelativePose& pose);

// Two cameras whose relative pose is known.
struct StereoRig {
  Matrix3d left_intrinsic = Matrix3d::Identity(), right_intrinsic = Matrix3d::Identity();
  RelativePose pose;
};

// The fundamental matrix F for the rig's pixels.
Matrix3d fundamental_of(const StereoRig& rig);

// The linear method. A point P that the camera with the matrix rows p_1, p_2, p_3 sees at (x, y)
// fulfils x (p_3 P) - p_1 P = 0 and y (p_3 P) - p_2 P = 0. The result is the null vector of the
// four equations of both cameras, in pixels; it minimises an algebraic error. The normalised
// version uses points on the planes at distance 1, with each equation scaled to norm 1.
Triangulated triangulate_linear(const Match& pixels, const StereoRig& rig);
Triangulated triangulate_linear_normalised(const Match& pixels, const StereoRig& rig);

// The nearest two pixels, in the least squares sense, that fulfil the epipolar constraint; their
// rays meet. By iteration: Lindstrom, Triangulation Made Easy, CVPR 2010 (two iterations). By
// roots: Hartley and Sturm, Triangulation, CVIU 68, 1997 (the roots of a polynomial of degree 6). A
// pixel at the epipole fulfils the constraint with every pixel, so such a match is not changed.
Match corrected_by_iteration(const Match& pixels, const Matrix3d& fundamental);
Match corrected_by_roots(const Match& pixels, const Matrix3d& fundamental);

enum class Triangulator { kMidpoint, kLinear, kLinearNormalised, kLindstrom, kHartleySturm };
inline constexpr Triangulator kTriangulators[] = {
    Triangulator::kMidpoint, Triangulator::kLinear, Triangulator::kLinearNormalised,
    Triangulator::kLindstrom, Triangulator::kHartleySturm};
const char* name_of(Triangulator triangulator);
Triangulated triangulate(Triangulator triangulator, const Match& pixels, const StereoRig& rig);

// The point's covariance if each coordinate of both pixels has an error of `sigma` pixels: (J^T
// J)^-1 sigma^2, where J has the derivatives of the four pixel coordinates with respect to the
// point. It gives the axes of an error ellipsoid; infinite if the rays are parallel.
Matrix3d covariance_of(const Vector3d& point, const StereoRig& rig, double sigma);

// The standard deviation of the depth Z for cameras with parallel axes: Z^2 sqrt(2) sigma/(f B) for
// the focal length f and the baseline B (S2-13).
double depth_error_of_parallel(double depth, double sigma, double focal_length, double baseline);

// The distance in pixels between the point's projection and the pixel of the match: the larger one
// of the two cameras' distances.
double reprojection_error(const Vector3d& point, const Match& pixels, const StereoRig& rig);

}  // namespace glassbox::views
