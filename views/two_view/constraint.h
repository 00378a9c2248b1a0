// The epipolar constraint: T, P_l and P_r - seen from the left camera - lie in one plane, so that p_r^T E p_l = 0 (S2-07 to S2-11).
// Over any number type, so that what is exact can be seen to be (tests take rationals).
#pragma once

#include <Eigen/Core>

namespace glassbox::views {

template <class S>
using Matrix3Of = Eigen::Matrix<S, 3, 3>;
template <class S>
using Vector3Of = Eigen::Matrix<S, 3, 1>;

// S, for which S v = t x v (S2-08).
template <class S>
Matrix3Of<S> cross_matrix(const Vector3Of<S>& t) {
  const S zero(0);
  Matrix3Of<S> s;
  s << zero, -t[2], t[1],  //
      t[2], zero, -t[0],   //
      -t[1], t[0], zero;
  return s;
}

// E = R S: P_r^T R S P_l = 0 where P_r = R (P_l - T) (S2-09). Of rank 2; its singular values are |T|, |T| and 0.
template <class S>
Matrix3Of<S> essential(const Matrix3Of<S>& rotation, const Vector3Of<S>& translation) {
  return rotation * cross_matrix(translation);
}

// The other textbooks' form, for P_r = R P_l + t: [t]x R. With t = -R T it is -R S; the sign says nothing, the order does.
template <class S>
Matrix3Of<S> essential_of_shift(const Matrix3Of<S>& rotation, const Vector3Of<S>& shift) {
  return cross_matrix(shift) * rotation;
}

// F = K_r^-T E K_l^-1, between pixels; the inverses are given, because a number type may have no way to find them.
template <class S>
Matrix3Of<S> fundamental(const Matrix3Of<S>& essential, const Matrix3Of<S>& inverse_left,
                         const Matrix3Of<S>& inverse_right) {
  return inverse_right.transpose() * essential * inverse_left;
}

// Demazure's 2 E E^T E - tr(E E^T) E: zero for a matrix of rank 2 just where it is some R S.
template <class S>
Matrix3Of<S> demazure(const Matrix3Of<S>& e) {
  const Matrix3Of<S> square = e * e.transpose();
  return S(2) * (square * e) - square.trace() * e;
}

// Where the point of the right picture has to lie: u_r = E p_l, as a x + b y + c = 0 (S2-11). E^T p_r is the left one's.
template <class S>
Vector3Of<S> epipolar_line(const Matrix3Of<S>& matrix, const Vector3Of<S>& point) {
  return matrix * point;
}

}  // namespace glassbox::views
