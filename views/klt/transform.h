// The Karhunen-Loeve transform of pictures of several bands: it expresses the pixels' colours along
// the directions in which they vary most, and each of these components is uncorrelated with the
// others (Karhunen 1947, Loeve 1948; S1-14).
//
// With the mean m and the covariance C = mean of (x - m)(x - m)^T = V diag(lambda) V^T, the
// components of a pixel x are s = V^T (x - m). From k of them, x is approximated by m + V_k s_k.
// The mean square of the error is the sum of the dropped eigenvalues: exactly, because m and C are
// those of the same pixels.
#pragma once

#include <vector>

#include <Eigen/Core>

#include <glassbox/base/error.h>

#include "views/klt/bands.h"

namespace glassbox::views {

struct Klt {
  Eigen::VectorXd mean;
  Eigen::MatrixXd covariance;   // of these pixels themselves: the sum is divided by their number
  Eigen::VectorXd eigenvalues;  // descending, none below 0
  // Orthonormal, one column for each eigenvalue. The entry of a column with the largest absolute
  // value is positive (of equal ones, the first).
  Eigen::MatrixXd vectors;

  double trace() const { return eigenvalues.sum(); }
  // The sum of the eigenvalues from index `kept` on, the smallest first: the mean squared error
  // when only the first `kept` components are kept.
  double truncation_error(int kept) const;
};

// The mean and the covariance in two passes: the second one sums products of differences to the
// mean, so that a large mean costs no accuracy (C-115). Sums are made row by row, so that a sum has
// W + H roundings and not W H.
struct Moments {
  Eigen::VectorXd mean;
  Eigen::MatrixXd covariance;
};
Moments moments_of(const Bands& bands);

// Refused: no band, fewer than two pixels, bands of several sizes, samples that are not finite or
// whose squares overflow.
Result<Klt> klt_of(const Bands& bands);

// The components with the indices from `first` to `end` - 1, named "component 1" ...
Bands components_of(const Bands& bands, const Klt& klt, int end, int first = 0);

// The pixels that are reconstructed from these components. The bands get the names of `named`.
Bands reconstructed(const Bands& components, const Klt& klt, const Bands& named);

// The mean over the pixels of the squared distance between two colours; the squared distance is a
// sum over the bands.
double mean_squared_error(const Bands& a, const Bands& b);

// An upper bound of the difference that rounding can make between a measured error and
// truncation_error(). It has three parts. First, 1e-10 of truncation_error(), as the requirement
// S1-14 allows. Second, the error of the eigenvalues themselves, which matters if nearly all
// components are kept: by Weyl's inequality each is off by at most |C' - C| <= (W + H + 3 B) u
// trace, with W + H roundings from the sums and 3 B from the products with V, and there are B
// eigenvalues. Third, the reconstructed pixels are rounded when the mean is added: for samples of
// at most M by r = u sqrt(B) (1 + 2 sqrt(B)) M together, as |m| <= M and |x - m| <= 2 sqrt(B) M;
// this changes the mean square by at most 2 sqrt(dropped) r + r^2 (Cauchy and Schwarz).
double identity_bound(const Bands& bands, const Klt& klt, int kept);

// An upper bound of the rounding error of one eigenvalue, by the same inequality.
double eigenvalue_bound(const Bands& bands, const Klt& klt);

// Groups neighbouring eigenvalues that are so close that rounding alone could exchange them: within
// a group only the space that its vectors span is determined. Returns for each eigenvalue the first
// index of its group.
std::vector<int> eigenvalue_groups(const Eigen::VectorXd& eigenvalues, double resolution);

// The largest principal angle in radians between the spaces that the orthonormal columns of a and b
// span. It is the arcsine of the norm of the part of B that is perpendicular to A, and therefore
// accurate for small angles, where an arccosine is not.
double angle_between(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

// The largest covariance of two different components, as a share of the trace (0 where the trace is
// 0).
double largest_correlation(const Bands& components);

}  // namespace glassbox::views
