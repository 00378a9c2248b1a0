// Predicts the errors of the methods to warp samples (D-14). Each rounding error is uniformly
// distributed within half a unit in the last place; it repeats if the same step is added again to a
// number of the same size.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Core>

#include "study/experiments/d14_methods.h"
#include "study/experiments/rounding_model.h"

namespace glassbox::study::d14 {

// The unit in the last place of a value in T.
template <class T>
double unit_at(double value) {
  return double(ulp(T(value)));
}
// The mean square of one rounding error in T.
template <class T>
double rounding_at(double value) {
  return square(rms_of_step(unit_at<T>(value)));
}

// One coordinate along a row: a sum to which the same step is added repeatedly. While the sum stays
// between two powers of two, each addition has the same rounding error, so n additions have n times
// that error; errors between different powers of two are independent.
template <class T>
class Drift {
public:
  // Starts with a value whose error has this variance.
  void begin(double value, double step, double variance = 0) {
    value_ = value, step_ = step, before_ = variance + rounding_at<T>(value);
    steps_ = alike_ = 0;
    unit_ = 0;
  }
  void next() {
    value_ += step_;
    ++steps_;
    const double unit = unit_at<T>(value_);
    if (unit != unit_) {
      before_ += square(rms_of_step(alike_ * unit_));
      alike_ = 0;
      unit_ = unit;
    }
    // If the step is a multiple of the sum's last unit, the sum is not rounded.
    alike_ += std::remainder(double(T(step_)), unit) == 0 ? 0 : 1;
  }
  double value() const { return value_; }
  double variance() const {
    return before_ + square(rms_of_step(alike_ * unit_)) +
           square(rms_of_step(steps_ * unit_at<T>(step_)));
  }

private:
  double value_ = 0, step_ = 0, before_ = 0, unit_ = 0;
  int steps_ = 0, alike_ = 0;
};

// The variance of start + z depth: the entry of the column depth, its product with z, and the sum
// are rounded.
template <class T>
double with_depth(double start, double start_variance, double depth, double z) {
  return start_variance + square(z) * rounding_at<T>(depth) + rounding_at<T>(z * depth) +
         rounding_at<T>(start + z * depth);
}

// For each method: the mean squares of the error of one coordinate of a sample.
template <class Method>
struct Model;

template <class T>
struct Model<FullProduct<T>> {
  using Number = T;
  void begin_row(const Eigen::RowVector4d& m, int y, int) { m_ = m, y_ = y + 0.5, x_ = 0.5; }
  void next() { x_ += 1; }
  double variance(double z) const {
    const double x = m_[0] * x_, y = m_[1] * y_, d = m_[2] * z;
    return square(x_) * rounding_at<T>(m_[0]) + square(y_) * rounding_at<T>(m_[1]) +
           square(z) * rounding_at<T>(m_[2]) + rounding_at<T>(m_[3]) + rounding_at<T>(x) +
           rounding_at<T>(y) + rounding_at<T>(d) + rounding_at<T>(x + y) +
           rounding_at<T>(x + y + d) + rounding_at<T>(x + y + d + m_[3]);
  }

private:
  Eigen::RowVector4d m_;
  double x_ = 0, y_ = 0;
};

template <class T, int Anchor>
struct Model<Additions<T, Anchor>> {
  using Number = T;
  void begin_row(const Eigen::RowVector4d& m, int y, int bottom) {
    m_ = m, y_ = y, x_ = 0;
    double variance = 0;
    if constexpr (Anchor == kNever) {
      Drift<T> up;
      up.begin(value_at(0, bottom), -m[1]);
      for (int i = bottom; i > y; --i) up.next();
      variance = up.variance();
    }
    drift_.begin(value_at(0, y), m[0], variance);
  }
  void next() {
    ++x_;
    if (Anchor != kNever && Anchor != kLine && x_ % std::max(Anchor, 1) == 0) {
      drift_.begin(value_at(x_, y_), m_[0]);
    } else {
      drift_.next();
    }
  }
  double variance(double z) const {
    return with_depth<T>(drift_.value(), drift_.variance(), m_[2], z);
  }

private:
  double value_at(int x, int y) const { return m_[0] * (x + 0.5) + m_[1] * (y + 0.5) + m_[3]; }
  Eigen::RowVector4d m_;
  Drift<T> drift_;
  int x_ = 0, y_ = 0;
};

template <>
struct Model<Multiples> {
  using Number = float;
  void begin_row(const Eigen::RowVector4d& m, int y, int) { m_ = m, y_ = y, x_ = 0; }
  void next() { ++x_; }
  double variance(double z) const {
    const int steps = x_ % Multiples::kAnchor;
    const double start = m_[0] * (x_ + 0.5) + m_[1] * (y_ + 0.5) + m_[3];
    const double anchor = start - steps * m_[0];
    double variance = rounding_at<float>(anchor);
    if (steps > 0)
      variance += square(steps) * rounding_at<float>(m_[0]) + rounding_at<float>(steps * m_[0]) +
                  rounding_at<float>(start);
    return with_depth<float>(start, variance, m_[2], z);
  }

private:
  Eigen::RowVector4d m_;
  int x_ = 0, y_ = 0;
};

// Fixed point. The rounded step is added x times, so its error grows x-fold; the start, the column
// of depth and the product are rounded once each. `step_` is kPlace for x and y, kShare for w.
template <>
struct Model<FixedPoint> {
  using Number = double;
  void begin_row(const Eigen::RowVector4d& m, int, int) { m_ = m, x_ = 0; }
  void next() { ++x_; }
  void set_step(double step) { step_ = step; }
  double variance(double z) const {
    return (square(x_) + 2 + square(z)) * square(rms_of_step(step_)) +
           square(rms_of_step(FixedPoint::kDepth) * m_[2]);
  }

private:
  Eigen::RowVector4d m_;
  double step_ = 0;
  int x_ = 0;
};

struct Predicted {
  double mean_square = 0;  // px^2, x and y together, without the rounding of the division
  double moved = 0;        // fraction of the samples that reach another pixel
};

// The probability that a coordinate reaches another pixel, if it is anywhere in its own pixel and
// its error e is normally distributed: the mean of min(1, |e|).
inline double share_moved(double deviation) {
  const double pixel = 1 / deviation;
  return std::erfc(pixel / std::numbers::sqrt2) +
         kMeanOfNormal * deviation * -std::expm1(-pixel * pixel / 2);
}

// Averages over every `every`-th row of one warp. The error of a coordinate x is (dX - x dW)/w,
// where dX and dW are the errors of x w and w.
template <class Method>
Predicted predict(const views::LayeredImage& image, const Eigen::Matrix4d& m, int every) {
  Predicted sum;
  double samples = 0;
  const int width = image.camera.width, height = image.camera.height;
  for (int y = height - 1; y >= 0; y -= every) {
    Model<Method> x_of, y_of, w_of;
    if constexpr (std::is_same_v<Method, FixedPoint>) {
      x_of.set_step(FixedPoint::kPlace);
      y_of.set_step(FixedPoint::kPlace);
      w_of.set_step(FixedPoint::kShare);
    }
    x_of.begin_row(m.row(0), y, height - 1);
    y_of.begin_row(m.row(1), y, height - 1);
    w_of.begin_row(m.row(3), y, height - 1);
    for (int x = 0; x < width; ++x) {
      const std::size_t place = image.pixel_index(x, y);
      for (std::uint32_t i = image.first[place]; i < image.first[place + 1]; ++i) {
        const double z = double(image.depth[i]);
        const Eigen::Vector4d at = m * Eigen::Vector4d(x + 0.5, y + 0.5, z, 1);
        const double w = at.w(), of_w = w_of.variance(z);
        using T = typename Model<Method>::Number;
        for (const auto& [place_px, variance] :
             {std::pair(at.x() / w, x_of.variance(z)), std::pair(at.y() / w, y_of.variance(z))}) {
          const double before = (variance + square(place_px) * of_w) / square(w);
          sum.mean_square += before;
          // The division rounds twice: 1/w, and the product with it.
          const double after =
              before + rounding_at<T>(place_px) + square(place_px * w) * rounding_at<T>(1 / w);
          sum.moved += share_moved(std::sqrt(after));
        }
        ++samples;
      }
      x_of.next(), y_of.next(), w_of.next();
    }
  }
  return {sum.mean_square / samples, sum.moved / samples};
}

}  // namespace glassbox::study::d14
