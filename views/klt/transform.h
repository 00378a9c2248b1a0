// The Karhunen-Loeve transform of pictures of several bands: the pixels' colours in the directions along which they vary most, each
// uncorrelated with the others (Karhunen 1947, Loeve 1948; SPEC S1-14).
//
// With the mean m and the covariance C = mean of (x - m)(x - m)^T = V diag(lambda) V^T, the components of a pixel x are s = V^T (x - m).
// Of k of them x is m + V_k s_k but for an error whose mean square is the sum of the eigenvalues that were dropped: exactly, because m
// and C are those of the same pixels.
#pragma once

#include <vector>

#include <Eigen/Core>

#include <glassbox/base/error.h>

#include "views/klt/bands.h"

namespace glassbox::views {

struct Klt {
  Eigen::VectorXd mean;
  Eigen::MatrixXd covariance;   // of the pixels there are: divided by their number
  Eigen::VectorXd eigenvalues;  // descending, none below 0
  // Orthonormal, a column for each eigenvalue; the entry that is largest without its sign is positive, the first of equals.
  Eigen::MatrixXd vectors;

  double trace() const { return eigenvalues.sum(); }
  // The sum of the eigenvalues from `kept` on, the smallest first.
  double dropped(int kept) const;
};

// The mean and the covariance in two passes: sums of differences to the mean, which loses nothing to a large one (C-115), by rows, so
// that a sum has W + H roundings and not W H.
struct Moments {
  Eigen::VectorXd mean;
  Eigen::MatrixXd covariance;
};
Moments moments_of(const Bands& bands);

// Refused: no band, fewer than two pixels, bands of several sizes, samples that are not finite or so large that their squares are not.
Result<Klt> klt_of(const Bands& bands);

// The components before `end`, from `first` on, named "component 1" ...
Bands components_of(const Bands& bands, const Klt& klt, int end, int first = 0);

// The pixels that these components stand for; names of bands are those of `named`.
Bands reconstructed(const Bands& components, const Klt& klt, const Bands& named);

// The mean over the pixels of the squared distance, which is a sum over the bands.
double mean_squared_error(const Bands& a, const Bands& b);

// The largest difference that rounding makes between an error that was measured and dropped(): 1e-10 of it as SPEC S1-14 asks, and
// where nearly all is kept, what the eigenvalues themselves are off by. By Weyl's inequality that is |C' - C| <= (W + H + 3 B) u trace,
// W + H roundings from the sums, 3 B from the products with V; B eigenvalues of them. And what comes back is rounded where the mean is added:
// of samples of at most M by r = u sqrt(B) (1 + 2 sqrt(B)) M together, as |m| <= M and |x - m| <= 2 sqrt(B) M; which makes the mean square
// 2 sqrt(dropped) r + r^2 another (Cauchy and Schwarz).
double identity_bound(const Bands& bands, const Klt& klt, int kept);

// What one eigenvalue is off by, by the same inequality.
double eigenvalue_bound(const Bands& bands, const Klt& klt);

// Eigenvalues that rounding alone could exchange, as groups of neighbours: of a group only the space that its vectors span is determined.
// The first index of the group of each.
std::vector<int> groups_of(const Eigen::VectorXd& eigenvalues, double resolution);

// The largest principal angle between the spaces that orthonormal columns span, radians: the arc sine of the norm of what B has beside
// A, and therefore exact for small angles, where an arc cosine is not.
double angle_between(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

// The largest covariance of two different components, as a share of the trace (0 where that is 0).
double largest_correlation(const Bands& components);

}  // namespace glassbox::views
