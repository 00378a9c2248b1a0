// Two-view geometry with errors.
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include "views/two_view/estimate.h"
#include "views/two_view/linear_fit.h"
#include "views/two_view/pair_kind.h"
#include "views/two_view/pose.h"

namespace glassbox::study::naive {

using views::Matches;
using views::Matrix3d;

// ---- eight points ----

// Solves the eight-point equations in raw pixels, whose coefficients differ much in size: products
// of coordinates are about 10^5, and the last coefficient is 1.
inline Matrix3d fundamental_raw(const Matches& pixels) {
  const auto fit = views::fit_fundamental(pixels, views::Conditioning::kRaw);
  return fit ? fit->matrix : Matrix3d::Zero();
}

// Undoes the normalisation with the matrices exchanged: each picture gets the matrix of the other.
inline Matrix3d fundamental_carried_back_crosswise(const Matches& pixels) {
  const auto normal = views::normalised(pixels);
  if (!normal) return Matrix3d::Zero();
  const Matrix3d m = views::with_rank_two(views::linear_fit(normal->matches)->matrix);
  return normal->left.transpose() * m * normal->right;
}

// Returns the matrix of the normalised points without undoing the normalisation.
inline Matrix3d fundamental_not_carried_back(const Matches& pixels) {
  const auto normal = views::normalised(pixels);
  return normal ? views::with_rank_two(views::linear_fit(normal->matches)->matrix)
                : Matrix3d::Zero();
}

// Solves the equations with the matrix A by an eigenvector of A^T A, whose condition number is the
// square of that of A.
template <class T>
Matrix3d matrix_by_normal_equations(const Matches& matches) {
  const Eigen::Matrix<T, Eigen::Dynamic, 9> rows = views::design_matrix(matches).cast<T>();
  const Eigen::Matrix<T, 9, 9> product = rows.transpose() * rows;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<T, 9, 9>> solver(product);
  const Eigen::Matrix<double, 9, 1> x = solver.eigenvectors().col(0).template cast<double>();
  Matrix3d matrix;
  matrix << x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8];
  return matrix;
}

// Makes the singular values equal too early, for the normalised points: undoing the normalisation
// makes them different again.
inline Matrix3d essential_made_before_carrying_back(const Matches& calibrated) {
  const auto normal = views::normalised(calibrated);
  if (!normal) return Matrix3d::Zero();
  const Matrix3d m = views::nearest_essential(views::linear_fit(normal->matches)->matrix);
  return normal->right.transpose() * m * normal->left;
}

// Returns a matrix of rank 2 with two different singular values: it is a fundamental matrix, not an
// essential one.
inline Matrix3d essential_of_rank_two(const Matches& calibrated) {
  const auto normal = views::normalised(calibrated);
  if (!normal) return Matrix3d::Zero();
  const Matrix3d m = views::linear_fit(normal->matches)->matrix;
  return views::with_rank_two(normal->right.transpose() * m * normal->left);
}

// ---- what kind of pair it is ----

// Takes every pair of cameras for a general one, whatever the eight-point method found.
inline views::PairKind always_general(const views::PairClassification&) {
  return views::PairKind::kGeneral;
}

// Takes a pure rotation for a plane, because the matches of both satisfy a homography. For a plane,
// five calibrated points give the relative pose; for a rotation they do not.
inline views::PairKind turned_is_a_plane(const views::PairClassification& judged) {
  return judged.kind == views::PairKind::kPureRotation ? views::PairKind::kPlane : judged.kind;
}

// ---- poses and points ----

inline views::RelativePose first_of_four(const Matrix3d& essential, const Matches&) {
  return views::poses_of(essential)[0];
}

// Tries both signs of the translation T, but only one of the two rotations.
inline views::RelativePose one_rotation(const Matrix3d& essential, const Matches& calibrated) {
  const auto poses = views::poses_of(essential);
  return views::in_front_of_both(poses[0], calibrated) >=
                 views::in_front_of_both(poses[1], calibrated)
             ? poses[0]
             : poses[1];
}

// Chooses the pose for which most points have a positive depth in the left camera; the right camera
// is not tested.
inline views::RelativePose in_front_of_left(const Matrix3d& essential, const Matches& calibrated) {
  views::RelativePose best;
  int most = -1;
  for (const views::RelativePose& pose : views::poses_of(essential)) {
    int count = 0;
    for (const views::Match& m : calibrated)
      count += views::midpoint({m.left.homogeneous(), m.right.homogeneous()}, pose).point.z() > 0;
    if (count <= most) continue;
    best = pose;
    most = count;
  }
  return best;
}

// Intersects two lines of sight by solving equations with a division: parallel lines divide by 0,
// and points behind the cameras are not told apart from points in front.
inline views::Triangulated by_division(const views::Match& pixels, const views::StereoRig& rig) {
  const views::Rays rays = views::rays_of(pixels, rig.left_intrinsic, rig.right_intrinsic);
  const Eigen::Vector3d d = rays.left, e = rig.pose.rotation.transpose() * rays.right;
  const Eigen::Vector3d across = d.cross(e);
  const double along = rig.pose.translation.cross(e).dot(across) / across.squaredNorm();
  views::Triangulated found;
  found.point = (along * d).homogeneous();
  found.in_front_of_both = true;
  return found;
}

}  // namespace glassbox::study::naive
