// Computes the matrix M of the constraint p_r^T M p_l = 0 from matches: solves a linear system for
// its nine entries (S2-12). M is F for pixels, and E for calibrated points.
#pragma once

#include <Eigen/Core>

#include <glassbox/base/error.h>

#include "views/two_view/match.h"

namespace glassbox::views {

// One row for each match: the products of the coordinates of (x_r, y_r, 1) and (x_l, y_l, 1), in
// the order of M's entries by rows.
Eigen::Matrix<double, Eigen::Dynamic, 9> design_matrix(const Matches& matches);

// Matches moved and scaled, in each picture, so that the centroid is 0 and the mean distance from
// it is the square root of 2 (Hartley, In Defense of the Eight-Point Algorithm, PAMI 19, 1997). An
// error if all points of a picture are equal.
struct Normalised {
  Matches matches;
  Eigen::Matrix3d left, right;  // transforms: the normalised left point is left * (x, y, 1)
};
Result<Normalised> normalised(const Matches& matches);

struct LinearFit {
  Eigen::Matrix3d matrix;  // not yet of rank 2; of Frobenius norm 1
  // In descending order; the last ones are 0 if there are fewer than nine matches.
  Eigen::Matrix<double, 9, 1> singular_values;
  // The directions that no equation constrains, one column for each.
  Eigen::Matrix<double, 9, Eigen::Dynamic> kernel;

  // The number of independent equations. A row's entries are rounded once, so singular values below
  // 16 u times the largest one (u: the unit roundoff, 2^-53) are taken for 0.
  int rank() const;
  // The condition number of the system for the eight unknowns that M has apart from its scale: the
  // first singular value divided by the eighth.
  double condition() const { return singular_values[0] / singular_values[7]; }
};

// The least squares solution; an error for fewer than `least` matches, or for numbers that are not
// finite.
Result<LinearFit> linear_fit(const Matches& matches, int least = 8);

// The eight-point algorithm: with raw points, or with normalised points and a result that is
// transformed back. F gets rank 2 in the coordinates in which the system was solved. E gets its
// form, with the singular values s, s and 0, in calibrated coordinates, so after the transformation
// back (C-106).
enum class Conditioning { kRaw, kNormalised };
struct EightPointFit {
  Eigen::Matrix3d matrix;
  LinearFit system;  // in the coordinates in which it was solved
};
Result<EightPointFit> fit_fundamental(const Matches& pixels, Conditioning conditioning);
Result<EightPointFit> fit_essential(const Matches& calibrated, Conditioning conditioning);

// The nearest matrix of rank 2, and the nearest matrix with the singular values s, s and 0,
// measured in the Frobenius norm.
Eigen::Matrix3d with_rank_two(const Eigen::Matrix3d& matrix);
Eigen::Matrix3d nearest_essential(const Eigen::Matrix3d& matrix);

}  // namespace glassbox::views
