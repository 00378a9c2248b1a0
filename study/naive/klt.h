// Wrong ways to compute the principal components of image bands.
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>
#include <Eigen/SVD>

#include "views/klt/transform.h"

namespace glassbox::study::naive {

// ---- covariance ----

// Computes the covariance as E[x y] - E[x] E[y] in one pass, which is the difference of two large
// and nearly equal numbers.
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

// The covariance of a sample instead of the whole population (N - 1 instead of N pixels): the sum
// of the eigenvalues that are left out is then not the error of these pixels.
inline Eigen::MatrixXd covariance_of_a_sample(const views::Bands& bands) {
  const double pixels = double(bands.pixels());
  return views::moments_of(bands).covariance * (pixels / (pixels - 1));
}

// The covariance without subtracting the mean.
inline Eigen::MatrixXd covariance_about_zero(const views::Bands& bands) {
  const views::Moments moments = views::moments_of(bands);
  return moments.covariance + moments.mean * moments.mean.transpose();
}

// ---- comparisons of components ----

// The angle between the first eigenvectors of two results. They are taken as unique, although every
// vector of a plane is an eigenvector if two eigenvalues are equal.
inline double angle_of_vectors(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return views::angle_between(a.col(0), b.col(0));
}

// The largest angle between eigenvectors with the same index. They are taken as unique up to their
// sign, although eigenvalues may be equal.
inline double largest_angle_of_vectors(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  double largest = 0;
  for (Eigen::Index i = 0; i < a.cols(); ++i)
    largest = std::max(largest, views::angle_between(a.col(i), b.col(i)));
  return largest;
}

// Computes the angle from its cosine, which is inaccurate: cos(x) rounds to 1 for all x below the
// square root of the unit roundoff.
inline double angle_by_cosine(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  const Eigen::MatrixXd cosines = a.transpose() * b;
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(cosines);
  return std::acos(std::min(1.0, svd.singularValues()[svd.singularValues().size() - 1]));
}

}  // namespace glassbox::study::naive
