// Components of bands that go wrong.
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>
#include <Eigen/SVD>

#include "views/klt/transform.h"

namespace glassbox::study::naive {

// ---- covariance ----

// E[x y] - E[x] E[y], in one pass: what is left of two large numbers that are nearly the same.
template <class F>
Eigen::MatrixXd covariance_by_moments(const views::Bands& bands) {
  const int count = bands.count();
  const F pixels = F(bands.pixels());
  Eigen::MatrixXd covariance(count, count);
  for (int a = 0; a < count; ++a) {
    for (int b = 0; b < count; ++b) {
      F sum_a = 0, sum_b = 0, sum_ab = 0;
      for (std::size_t i = 0; i < bands.pixels(); ++i) {
        const F x = F(bands.bands[std::size_t(a)].samples[i]);
        const F y = F(bands.bands[std::size_t(b)].samples[i]);
        sum_a += x;
        sum_b += y;
        sum_ab += x * y;
      }
      covariance(a, b) = double(sum_ab / pixels - sum_a / pixels * (sum_b / pixels));
    }
  }
  return covariance;
}

// Of a sample instead of all there is: a sum of eigenvalues that were dropped is then no error of these pixels.
inline Eigen::MatrixXd covariance_of_a_sample(const views::Bands& bands) {
  const double pixels = double(bands.pixels());
  return views::moments_of(bands).covariance * (pixels / (pixels - 1));
}

// The mean is not taken away.
inline Eigen::MatrixXd covariance_about_zero(const views::Bands& bands) {
  const views::Moments moments = views::moments_of(bands);
  return moments.covariance + moments.mean * moments.mean.transpose();
}

// ---- what components are compared by ----

// The first vectors, as if each eigenvalue had one.
inline double angle_of_vectors(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return views::angle_between(a.col(0), b.col(0));
}

// Eigenvalues may be equal, signs are thought to be the only choice that is left.
inline double largest_angle_of_vectors(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  double largest = 0;
  for (Eigen::Index i = 0; i < a.cols(); ++i)
    largest = std::max(largest, views::angle_between(a.col(i), b.col(i)));
  return largest;
}

// cos(x) is 1 for all x below the root of the unit roundoff.
inline double angle_by_cosine(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  const Eigen::MatrixXd cosines = a.transpose() * b;
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(cosines);
  return std::acos(std::min(1.0, svd.singularValues()[svd.singularValues().size() - 1]));
}

}  // namespace glassbox::study::naive
