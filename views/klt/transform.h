// The Karhunen-Loeve transform of pictures of several bands: it expresses the pixels' colours along
// the directions in which they vary most, and each of these components is uncorrelated with the
// others (Karhunen 1947, Loeve 1948; S1-14).
//
// With the mean m and the covariance C = mean of (x - m)(x - m)^T = V diag(lambda) V^T, the
// components of a pixel x are s = V^T (x - m). From the first k of them, s_k, and the first k
// columns of V, V_k, x is approximated by m + V_k s_k. The mean square of the error is exactly the
// sum of the dropped eigenvalues, because m and C are those of the same pixels.
#pragma once

#include <vector>

#include <Eigen/Core>

#include <glassbox/base/error.h>

#include "views/klt/bands.h"

namespace glassbox::views {

struct Klt {
  Eigen::VectorXd mean;
  Eigen::MatrixXd covariance;   // the sum of products divided by the number of pixels
  Eigen::VectorXd eigenvalues;  // descending, none below 0
  // The eigenvectors: orthonormal, one column for each eigenvalue. The entry with the largest
  // absolute value in a column is positive (if several are equal, the first of them).
  Eigen::MatrixXd vectors;

  double trace() const { return eigenvalues.sum(); }
  // The sum of the eigenvalues from index `kept` on, the smallest first: the mean squared error
  // when only the first `kept` components are kept.
  double truncation_error(int kept) const;
};

// The mean and the covariance in two passes: the second one sums products of differences to the
// mean, so that a large mean costs no accuracy (C-115). Sums are made row by row, and then over the
// rows, so that a number goes through at most W + H roundings in a picture of W x H pixels, and not
// W H.
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
// truncation_error(), for B bands of W x H pixels and u (the unit roundoff, 2^-53). It is the sum
// of three parts. First, 1e-10 of truncation_error(), as the requirement S1-14 allows. Second, the
// errors of the B eigenvalues, which matter if nearly all components are kept: by Weyl's inequality
// each is off by at most the norm |C' - C| of the error of the computed covariance C', which is at
// most (W + H + 3 B) u trace, with W + H roundings from the sums and 3 B from the products with V.
// Third, the reconstructed pixels are rounded when the mean is added: for samples of at most M, |m|
// <= M and |x - m| <= 2 sqrt(B) M, so a pixel is off by at most r = u sqrt(B) (1 + 2 sqrt(B)) M. If
// D is the sum of the dropped eigenvalues, this changes the mean square by at most 2 sqrt(D) r +
// r^2 (inequality of Cauchy and Schwarz).
double identity_bound(const Bands& bands, const Klt& klt, int kept);

// An upper bound of the rounding error of one eigenvalue, (W + H + 3 B) u trace (see
// identity_bound).
double eigenvalue_bound(const Bands& bands, const Klt& klt);

// Groups neighbouring eigenvalues that are so close that rounding alone could exchange them: within
// a group only the space that its vectors span is determined. Returns for each eigenvalue the first
// index of its group.
std::vector<int> eigenvalue_groups(const Eigen::VectorXd& eigenvalues, double resolution);

// The largest principal angle in radians between the spaces that the orthonormal columns of a and b
// span. It is the arcsine of the norm of the part of b that is perpendicular to a, which is
// accurate for small angles, where an arccosine is not.
double angle_between(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

// The largest absolute covariance of two different components, as a fraction of the trace of the
// covariance matrix (0 where the trace is 0).
double largest_correlation(const Bands& components);

}  // namespace glassbox::views
