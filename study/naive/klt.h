// Wrong ways to compute the principal components of image bands.
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>
#include <Eigen/SVD>

#include "views/klt/transform.h"

namespace glassbox::study::naive {

// ---- covariance ----

// E[x y] - E[x] E[y] in one pass: the difference of two large numbers that are nearly equal.
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

// The covariance of a sample instead of the whole population: the sum of the dropped eigenvalues is
// then not the error of these pixels.
inline Eigen::MatrixXd covariance_of_a_sample(const views::Bands& bands) {
  const double pixels = double(bands.pixels());
  return views::moments_of(bands).covariance * (pixels / (pixels - 1));
}

// The mean is not subtracted.
inline Eigen::MatrixXd covariance_about_zero(const views::Bands& bands) {
  const views::Moments moments = views::moments_of(bands);
  return moments.covariance + moments.mean * moments.mean.transpose();
}

// ---- what components are compared by ----

// Compares the first eigenvectors as if each were unique, although equal eigenvalues share a whole
// plane of them.
inline double angle_of_vectors(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return views::angle_between(a.col(0), b.col(0));
}

// Assumes that the eigenvectors are unique up to their sign, although eigenvalues may be equal.
inline double largest_angle_of_vectors(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  double largest = 0;
  for (Eigen::Index i = 0; i < a.cols(); ++i)
    largest = std::max(largest, views::angle_between(a.col(i), b.col(i)));
  return largest;
}

// cos(x) rounds to 1 for all x below the square root of the unit roundoff.
inline double angle_by_cosine(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  const Eigen::MatrixXd cosines = a.transpose() * b;
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(cosines);
  return std::acos(std::min(1.0, svd.singularValues()[svd.singularValues().size() - 1]));
}

}  // namespace glassbox::study::naive
