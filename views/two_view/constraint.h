// The epipolar constraint. For a point that the left camera sees at P_l and the right camera at
// P_r, the rays to it and the translation T between the cameras are in one plane, so that p_r^T E
// p_l = 0 for its images p_l and p_r (S2-07 to S2-11). The functions accept any number type; tests
// use rationals to check what is exact.
#pragma once

#include <Eigen/Core>

namespace glassbox::views {

template <class S>
using Matrix3Of = Eigen::Matrix<S, 3, 3>;
template <class S>
using Vector3Of = Eigen::Matrix<S, 3, 1>;

// The cross product matrix S, with S v = t x v (S2-08).
template <class S>
Matrix3Of<S> cross_matrix(const Vector3Of<S>& t) {
  const S zero(0);
  Matrix3Of<S> s;
  s << zero, -t[2], t[1],  //
      t[2], zero, -t[0],   //
      -t[1], t[0], zero;
  return s;
}

// The essential matrix E = R S, where S is the cross product matrix of T: P_r^T R S P_l = 0 for P_r
// = R (P_l - T) (S2-09). It has rank 2; its singular values are |T|, |T| and 0.
template <class S>
Matrix3Of<S> essential(const Matrix3Of<S>& rotation, const Vector3Of<S>& translation) {
  return rotation * cross_matrix(translation);
}

// The form in other textbooks, [t]x R, for P_r = R P_l + t. With t = -R T it equals -R S. The sign
// has no meaning, but the order of the factors matters.
template <class S>
Matrix3Of<S> essential_of_shift(const Matrix3Of<S>& rotation, const Vector3Of<S>& shift) {
  return cross_matrix(shift) * rotation;
}

// The fundamental matrix F = K_r^-T E K_l^-1, between pixels. The inverses are parameters, because
// a number type may have no way to compute them.
template <class S>
Matrix3Of<S> fundamental(const Matrix3Of<S>& essential, const Matrix3Of<S>& inverse_left,
                         const Matrix3Of<S>& inverse_right) {
  return inverse_right.transpose() * essential * inverse_left;
}

// Demazure's expression 2 E E^T E - tr(E E^T) E: for a matrix E of rank 2 it is zero exactly if E
// is of the form R S, with a rotation R and a cross product matrix S.
template <class S>
Matrix3Of<S> demazure(const Matrix3Of<S>& e) {
  const Matrix3Of<S> square = e * e.transpose();
  return S(2) * (square * e) - square.trace() * e;
}

// The epipolar line on which the point of the right picture has to be: u_r = E p_l, the line a x +
// b y + c = 0 with u_r = (a, b, c) (S2-11). For a line in the left picture, pass E^T and p_r.
template <class S>
Vector3Of<S> epipolar_line(const Matrix3Of<S>& matrix, const Vector3Of<S>& point) {
  return matrix * point;
}

}  // namespace glassbox::views
