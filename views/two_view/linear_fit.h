// The matrix of the constraint p_r^T M p_l = 0 from matches: solves a linear system for its nine
// entries (S2-12). M is F for pixels, and E for calibrated points.
#pragma once

#include <Eigen/Core>

#include <glassbox/base/error.h>

#include "views/two_view/match.h"

namespace glassbox::views {

// One row for each match: the products of the coordinates of (x_r, y_r, 1) and (x_l, y_l, 1), in
// the order of M's entries by rows.
Eigen::Matrix<double, Eigen::Dynamic, 9> design_matrix(const Matches& matches);

// Matches moved and scaled so that the centroid is 0 and the mean distance from it is the square
// root of 2 (Hartley, In Defense of the Eight-Point Algorithm, PAMI 19, 1997). An error if all
// points are equal.
struct Normalised {
  Matches matches;
  Eigen::Matrix3d left, right;  // normalised = left * (x, y, 1)
};
Result<Normalised> normalised(const Matches& matches);

struct LinearFit {
  Eigen::Matrix3d matrix;  // not yet of rank 2; of Frobenius norm 1
  // In descending order; 0 where fewer than nine matches give none.
  Eigen::Matrix<double, 9, 1> singular_values;
  Eigen::Matrix<double, 9, Eigen::Dynamic>
      kernel;  // the directions that no equation constrains, one column for each

  // The number of independent equations. A row's entries are rounded once, so singular values below
  // 16 u times the largest one count as 0.
  int rank() const;
  // The condition number of the system in the eight unknowns that M has apart from its scale: the
  // first singular value divided by the eighth.
  double condition() const { return singular_values[0] / singular_values[7]; }
};

// The least squares solution; an error for fewer than `least` matches, or for numbers that are not
// finite.
Result<LinearFit> linear_fit(const Matches& matches, int least = 8);

// The eight-point algorithm: with raw points, or with normalised points and a result that is
// transformed back. F gets rank 2 in the coordinates in which the system was solved; E gets its
// form (two equal singular values and 0) in calibrated coordinates, which is after transforming
// back (C-106).
enum class Conditioning { kRaw, kNormalised };
struct EightPointFit {
  Eigen::Matrix3d matrix;
  LinearFit system;  // as it was solved
};
Result<EightPointFit> fit_fundamental(const Matches& pixels, Conditioning conditioning);
Result<EightPointFit> fit_essential(const Matches& calibrated, Conditioning conditioning);

// In the Frobenius norm, the nearest matrix of rank 2, and the nearest one with singular values (s,
// s, 0).
Eigen::Matrix3d with_rank_two(const Eigen::Matrix3d& matrix);
Eigen::Matrix3d nearest_essential(const Eigen::Matrix3d& matrix);

}  // namespace glassbox::views
