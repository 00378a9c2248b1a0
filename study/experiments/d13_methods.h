// The methods to turn a rotation a little further at every step (D-13).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include <glassbox/base/trig.h>
#include <glassbox/pipeline/affine.h>

namespace glassbox::study {

template <class T>
using RotationMatrix = std::array<std::array<T, 3>, 3>;  // indexed [row][column]

inline constexpr double kStepRadians = 0.01;

// A turn of a hundredth of a radian about an axis that is not near any coordinate axis.
inline glm::dmat4 step_rotation() {
  return affine::rotation({1, 2, 3}, degrees_from_radians(kStepRadians)).value();
}

template <class T>
RotationMatrix<T> step_matrix() {
  const glm::dmat4 step = step_rotation();
  RotationMatrix<T> m;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) m[std::size_t(i)][std::size_t(j)] = T(step[j][i]);
  }
  return m;
}

template <class T>
RotationMatrix<T> operator*(const RotationMatrix<T>& a, const RotationMatrix<T>& b) {
  RotationMatrix<T> product;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      product[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
  }
  return product;
}

// ---- the methods ----

// Multiplies the matrix by the step. After every `renormalised_every` steps, its rows are made
// orthonormal again (Gram and Schmidt); 0: never.
template <class T>
class RotationProduct {
public:
  explicit RotationProduct(int renormalised_every) : every_(renormalised_every) {}

  void advance() {
    r_ = r_ * step_;
    if (every_ != 0 && ++since_ == every_) renormalise();
  }
  // Whether the error is at its largest: just before the next renormalisation.
  bool is_worst() const { return every_ == 0 || since_ == every_ - 1; }
  const RotationMatrix<T>& matrix() const { return r_; }

private:
  void renormalise() {
    auto& [u, v, w] = r_;
    normalise(u);
    const T along = v[0] * u[0] + v[1] * u[1] + v[2] * u[2];
    for (std::size_t i = 0; i < 3; ++i) v[i] -= along * u[i];
    normalise(v);
    w = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    since_ = 0;
  }
  static void normalise(std::array<T, 3>& a) {
    const T length = std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    for (T& x : a) x /= length;
  }

  int every_, since_ = 0;
  RotationMatrix<T> step_ = step_matrix<T>();
  RotationMatrix<T> r_{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
};

// A quaternion that is normalised at every step and converted to a matrix on request.
class RotationQuaternion {
public:
  explicit RotationQuaternion(int) {
    const AxisAngle turn = axis_angle_of(step_rotation());
    const SinCos half = sin_cos(turn.radians / 2);
    step_ = {float(half.cos), float(half.sin * turn.axis.x), float(half.sin * turn.axis.y),
             float(half.sin * turn.axis.z)};
  }

  void advance() {
    const auto [a, b, c, d] = q_;
    const auto [e, f, g, h] = step_;
    q_ = {a * e - b * f - c * g - d * h, a * f + b * e + c * h - d * g,
          a * g - b * h + c * e + d * f, a * h + b * g - c * f + d * e};
    const float length = std::sqrt(q_[0] * q_[0] + q_[1] * q_[1] + q_[2] * q_[2] + q_[3] * q_[3]);
    for (float& x : q_) x /= length;
  }
  bool is_worst() const { return true; }
  RotationMatrix<float> matrix() const {
    const auto [a, b, c, d] = q_;
    return {{{1 - 2 * (c * c + d * d), 2 * (b * c - a * d), 2 * (b * d + a * c)},
             {2 * (b * c + a * d), 1 - 2 * (b * b + d * d), 2 * (c * d - a * b)},
             {2 * (b * d - a * c), 2 * (c * d + a * b), 1 - 2 * (b * b + c * c)}}};
  }

private:
  std::array<float, 4> step_{}, q_{1, 0, 0, 0};
};

}  // namespace glassbox::study
