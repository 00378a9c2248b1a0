// The methods to warp the samples of a layered depth image row by row (D-14). All of them return
// start + z depth (S1-08): `start` belongs to the pixel, z is the sample's depth and `depth` a
// column of the matrix. They differ in how they compute `start`.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include <Eigen/Core>

#include "views/layers/layered_image.h"

namespace glassbox::study::d14 {

// Homogeneous coordinates x w, y w, z w and w, where (x, y) is a place in the other picture, in
// pixels. Only the timed drawing uses z w.
template <class T>
struct Warped {
  T x, y, z, w;
};
template <class T>
Warped<T> operator+(const Warped<T>& a, const Warped<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
}
template <class T>
Warped<T> operator*(T s, const Warped<T>& a) {
  return {s * a.x, s * a.y, s * a.z, s * a.w};
}
template <class T>
Warped<T> column(const Eigen::Matrix4d& m, int i) {
  return {T(m(0, i)), T(m(1, i)), T(m(2, i)), T(m(3, i))};
}
template <class T>
Warped<T> start_at(const Eigen::Matrix4d& m, int x, int y) {
  const Eigen::Vector4d at = m * Eigen::Vector4d(x + 0.5, y + 0.5, 0, 1);
  return {T(at.x()), T(at.y()), T(at.z()), T(at.w())};
}

// Multiplies the matrix by (x, y, depth, 1) for each sample.
template <class T>
class FullProduct {
public:
  FullProduct(const Eigen::Matrix4d& m, int)
      : columns_{column<T>(m, 0), column<T>(m, 1), column<T>(m, 2), column<T>(m, 3)} {}
  void begin_row(int y) { y_ = T(y) + T(0.5), x_ = T(0.5); }
  void next() { x_ += 1; }
  Warped<T> at(float depth) const {
    return ((x_ * columns_[0] + y_ * columns_[1]) + T(depth) * columns_[2]) + columns_[3];
  }

private:
  std::array<Warped<T>, 4> columns_;
  T x_ = 0, y_ = 0;
};

constexpr int kLine = 1 << 30;  // the start of each row is computed from the matrix
constexpr int kNever = 0;       // only the first start is; each row starts from the one before

// Adds one step per pixel. Every `Anchor` pixels the start is computed from the matrix instead, so
// that rounding errors do not add up further.
template <class T, int Anchor>
class Additions {
public:
  Additions(const Eigen::Matrix4d& m, int bottom)
      : matrix_(m),
        right_(column<T>(m, 0)),
        up_(T(-1) * column<T>(m, 1)),
        depth_(column<T>(m, 2)),
        row_(start_at<T>(m, 0, bottom)) {}
  // Rows are visited from bottom to top.
  void begin_row(int y) {
    y_ = y, x_ = 0;
    if constexpr (Anchor == kNever) {
      start_ = row_;
      row_ = row_ + up_;
    } else {
      start_ = start_at<T>(matrix_, 0, y);
    }
  }
  void next() {
    start_ = start_ + right_;
    if constexpr (Anchor != kNever && Anchor != kLine) {
      if (++x_ % Anchor == 0) start_ = start_at<T>(matrix_, x_, y_);
    }
  }
  Warped<T> at(float depth) const { return start_ + T(depth) * depth_; }

private:
  const Eigen::Matrix4d matrix_;
  Warped<T> right_, up_, depth_, row_, start_{};
  int x_ = 0, y_ = 0;
};

// Adds a multiple of the step, in one product, to a start that is computed anew every 64 pixels;
// views/layers does the same.
class Multiples {
public:
  static constexpr int kAnchor = 64;
  Multiples(const Eigen::Matrix4d& m, int)
      : matrix_(m), right_(column<float>(m, 0)), depth_(column<float>(m, 2)) {}
  void begin_row(int y) {
    y_ = y, x_ = 0;
    start_ = anchor_ = start_at<float>(matrix_, 0, y);
  }
  void next() {
    const int steps = ++x_ % kAnchor;
    if (steps == 0) anchor_ = start_at<float>(matrix_, x_, y_);
    start_ = anchor_ + float(steps) * right_;
  }
  Warped<float> at(float depth) const { return start_ + depth * depth_; }

private:
  const Eigen::Matrix4d matrix_;
  Warped<float> right_, depth_, anchor_{}, start_{};
  int x_ = 0, y_ = 0;
};

// Uses integers: x w and y w in units of 2^-17 px, w and z w in 2^-27, depth in 2^-24. Additions
// are exact; only the step is rounded to its unit.
class FixedPoint {
public:
  static constexpr double kPlace = 0x1p-17, kShare = 0x1p-27, kDepth = 0x1p-24;
  FixedPoint(const Eigen::Matrix4d& m, int)
      : matrix_(m), right_(fixed(m.col(0))), depth_(fixed(m.col(2))) {}
  void begin_row(int y) { start_ = fixed(matrix_ * Eigen::Vector4d(0.5, y + 0.5, 0, 1)); }
  void next() {
    for (std::size_t i = 0; i < 4; ++i) start_[i] += right_[i];
  }
  Warped<double> at(float depth) const {
    const auto z = std::int64_t(double(depth) / kDepth + 0.5);
    std::array<std::int64_t, 4> at{};
    for (std::size_t i = 0; i < 4; ++i)
      at[i] = start_[i] + ((z * depth_[i] + (std::int64_t(1) << 23)) >> 24);
    return {double(at[0]) * kPlace, double(at[1]) * kPlace, double(at[2]) * kShare,
            double(at[3]) * kShare};
  }

private:
  using Fixed = std::array<std::int64_t, 4>;
  static Fixed fixed(const Eigen::Vector4d& v) {
    return {std::llround(v.x() / kPlace), std::llround(v.y() / kPlace),
            std::llround(v.z() / kShare), std::llround(v.w() / kShare)};
  }
  const Eigen::Matrix4d matrix_;
  Fixed right_, depth_, start_{};
};

// Calls visit(x, y, sample, warped place) for all samples in the order in which the image stores
// them.
template <class Method, class Visit>
void warp_all(const views::LayeredImage& image, const Eigen::Matrix4d& matrix, Visit&& visit) {
  const int width = image.camera.width, height = image.camera.height;
  Method method(matrix, height - 1);
  std::size_t place = 0;
  for (int y = height; y-- > 0;) {
    method.begin_row(y);
    for (int x = 0; x < width; ++x, ++place, method.next()) {
      for (std::uint32_t i = image.first[place]; i < image.first[place + 1]; ++i)
        visit(x, y, i, method.at(image.depth[i]));
    }
  }
}

}  // namespace glassbox::study::d14
